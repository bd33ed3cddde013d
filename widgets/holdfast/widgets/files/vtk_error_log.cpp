#include "holdfast/widgets/files/vtk_error_log.h"

#include <mutex>
#include <string_view>

#include <vtkLogger.h>
#include <vtkObject.h>
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
class SharedConsole {
 public:
  void silence()
  {
    const std::lock_guard lock(mutex_);
    if (silencers_++ > 0) return;
    verbosity_ = vtkLogger::GetCurrentVerbosityCutoff();
    displayMode_ = vtkOutputWindow::GetInstance()->GetDisplayMode();
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
    vtkOutputWindow::GetInstance()->SetDisplayModeToNever();
  }

  void giveBack()
  {
    const std::lock_guard lock(mutex_);
    if (--silencers_ > 0) return;
    vtkLogger::SetStderrVerbosity(verbosity_);
    vtkOutputWindow::GetInstance()->SetDisplayMode(displayMode_);
  }

 private:
  std::mutex mutex_;
  int silencers_ = 0;
  vtkLogger::Verbosity verbosity_ = vtkLogger::VERBOSITY_INFO;
  int displayMode_ = vtkOutputWindow::DEFAULT;
};

SharedConsole& console()
{
  static SharedConsole shared;
  return shared;
}

}  // namespace

void VtkErrorLog::Observer::Execute(vtkObject* /*caller*/, unsigned long event, void* text)
{
  if (event == vtkCommand::ErrorEvent && first.empty()) first = reasonOf(static_cast<const char*>(text));
}

VtkErrorLog::VtkErrorLog() : observer_(vtkSmartPointer<Observer>::New())
{
  console().silence();
}

VtkErrorLog::~VtkErrorLog()
{
  console().giveBack();
}

void VtkErrorLog::watch(vtkObject& object)
{
  object.AddObserver(vtkCommand::ErrorEvent, observer_);
  object.AddObserver(vtkCommand::WarningEvent, observer_);
}

}  // namespace holdfast
