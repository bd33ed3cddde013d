#include "holdfast/threads/thread_priority.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>
#include <vector>

#include <sched.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace holdfast {
namespace {

// Steps as `nice` counts them: a tenth of the time of a core that a thread of higher priority needs as well.
constexpr int kSteps = 10;

pid_t thisThread() noexcept
{
  return static_cast<pid_t>(::syscall(SYS_gettid));
}

// On Linux a thread is what POSIX calls a process here.
void lowerPriority(pid_t thread) noexcept
{
  const auto id = static_cast<id_t>(thread);
  ::setpriority(PRIO_PROCESS, id, ::getpriority(PRIO_PROCESS, id) + kSteps);
}

/// All of this program, in the order in which they were started.
std::vector<pid_t> threads()
{
  std::vector<pid_t> found;
  std::error_code error;
  for (std::filesystem::directory_iterator entry("/proc/self/task", error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    pid_t thread = 0;
    std::from_chars(name.data(), name.data() + name.size(), thread);
    if (thread > 0) found.push_back(thread);
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::string nameOf(pid_t thread)
{
  std::ifstream file("/proc/self/task/" + std::to_string(thread) + "/comm");
  std::string name;
  std::getline(file, name);
  return name;
}

std::vector<int> usableCores()
{
  std::vector<int> cores;
  cpu_set_t usable;
  CPU_ZERO(&usable);
  if (::sched_getaffinity(0, sizeof(usable), &usable) != 0) return cores;
  for (int core = 0; core < CPU_SETSIZE; ++core)
    if (CPU_ISSET(core, &usable)) cores.push_back(core);
  return cores;
}

}  // namespace

void computeInBackground() noexcept
{
  lowerPriority(thisThread());
}

void letOthersComputeInBackground() noexcept
{
  for (const pid_t thread : threads())
    if (thread != thisThread()) lowerPriority(thread);
}

void spreadOverCores(std::string_view name) noexcept
{
  const std::vector<int> cores = usableCores();
  std::size_t next = 0;
  for (const pid_t thread : threads()) {
    if (cores.empty() || !nameOf(thread).starts_with(name)) continue;
    cpu_set_t only;
    CPU_ZERO(&only);
    CPU_SET(cores[next++ % cores.size()], &only);
    ::sched_setaffinity(thread, sizeof(only), &only);
  }
}

}  // namespace holdfast
