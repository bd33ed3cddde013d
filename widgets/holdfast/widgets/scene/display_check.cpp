#include "holdfast/widgets/scene/display_check.h"

#include <cerrno>
#include <csignal>
#include <cstdlib>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

namespace holdfast {
namespace {

// An X server that takes the connection and never answers.
constexpr unsigned kPatienceSeconds = 30;

/// The child: quiet, without a core file, and free of what the parent does on signals.
[[noreturn]] void tryInChild(const std::function<bool()>& attempt)
{
  const rlimit none{0, 0};
  ::setrlimit(RLIMIT_CORE, &none);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGABRT, SIGSEGV, SIGALRM}) std::signal(signal, SIG_DFL);
  ::alarm(kPatienceSeconds);
  if (const int nowhere = ::open("/dev/null", O_WRONLY); nowhere >= 0) {
    ::dup2(nowhere, STDOUT_FILENO);
    ::dup2(nowhere, STDERR_FILENO);
  }
  ::_exit(attempt() ? EXIT_SUCCESS : EXIT_FAILURE);
}

/// Ends the process where there is no X server or no OpenGL.
bool draws()
{
  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(8, 8);
  window->AddRenderer(renderer);
  window->Render();
  return true;
}

}  // namespace

bool succeedsInChild(const std::function<bool()>& attempt)
{
  const pid_t child = ::fork();
  if (child == 0) tryInChild(attempt);
  if (child < 0) return false;
  int status = 0;
  while (::waitpid(child, &status, 0) < 0)
    if (errno != EINTR) return false;
  return WIFEXITED(status) && WEXITSTATUS(status) == EXIT_SUCCESS;
}

std::string whyNoPictures()
{
  const char* const display = std::getenv("DISPLAY");
  if (display == nullptr || *display == '\0')
    return "pictures need an X server, and DISPLAY is not set: run under xvfb-run, or set DISPLAY";
  if (!succeedsInChild(draws))
    return "pictures need an X server with OpenGL, and \"" + std::string(display) +
           "\" (DISPLAY) is none: run under xvfb-run, or set DISPLAY to one that is";
  return {};
}

}  // namespace holdfast
