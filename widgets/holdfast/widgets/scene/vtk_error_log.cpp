#include "holdfast/widgets/scene/vtk_error_log.h"

#include <mutex>
#include <string_view>

#include <vtkLogger.h>
#include <vtkOutputWindow.h>

namespace holdfast {
namespace {

/// "ERROR: In file.cxx, line 12\nvtkReader (0x5581): Cannot read.\n\n" says "Cannot read."
std::string reasonOf(std::string_view text)
{
  constexpr std::string_view kEndOfOrigin = "): ";
  if (const auto origin = text.find(kEndOfOrigin); origin != std::string_view::npos)
    text.remove_prefix(origin + kEndOfOrigin.size());
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ' || text.back() == '.')) text.remove_suffix(1);
  return text.empty() ? "no reason given" : std::string(text);
}

/// VTK's console is one for the whole process: the first log silences it, the last one gives it back as it was.
struct SharedConsole {
  std::mutex mutex;
  int silencers = 0;
  vtkLogger::Verbosity verbosity = vtkLogger::VERBOSITY_INFO;
  int displayMode = vtkOutputWindow::DEFAULT;
};

constinit SharedConsole console;

}  // namespace

void VtkErrorLog::Observer::Execute(vtkObject* /*caller*/, unsigned long /*event*/, void* text)
{
  if (first.empty()) first = reasonOf(static_cast<const char*>(text));
}

VtkErrorLog::VtkErrorLog() : observer_(vtkSmartPointer<Observer>::New())
{
  const std::lock_guard lock(console.mutex);
  if (console.silencers++ > 0) return;
  console.verbosity = vtkLogger::GetCurrentVerbosityCutoff();
  console.displayMode = vtkOutputWindow::GetInstance()->GetDisplayMode();
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkOutputWindow::GetInstance()->SetDisplayModeToNever();
}

VtkErrorLog::~VtkErrorLog()
{
  const std::lock_guard lock(console.mutex);
  if (--console.silencers > 0) return;
  vtkLogger::SetStderrVerbosity(console.verbosity);
  vtkOutputWindow::GetInstance()->SetDisplayMode(console.displayMode);
}

}  // namespace holdfast
