#include "holdfast/base/thread_priority.h"

#if defined(__linux__)
#include <charconv>
#include <filesystem>
#include <string>
#include <system_error>

#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>
#endif

namespace holdfast {

#if defined(__linux__)

namespace {

// Of what `nice` counts: a tenth of the time of a core where a thread of the window wants it, too.
constexpr int kNiceness = 10;

pid_t thisThread() noexcept
{
  return static_cast<pid_t>(::syscall(SYS_gettid));
}

// On Linux a thread is what POSIX calls a process here.
void lowerPriority(pid_t thread) noexcept
{
  ::setpriority(PRIO_PROCESS, static_cast<id_t>(thread), kNiceness);
}

}  // namespace

void computeInBackground() noexcept
{
  lowerPriority(thisThread());
}

void letOthersComputeInBackground() noexcept
{
  std::error_code error;
  for (std::filesystem::directory_iterator entry("/proc/self/task", error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    pid_t thread = 0;
    std::from_chars(name.data(), name.data() + name.size(), thread);
    if (thread > 0 && thread != thisThread()) lowerPriority(thread);
  }
}

#else

void computeInBackground() noexcept {}

void letOthersComputeInBackground() noexcept {}

#endif

}  // namespace holdfast
