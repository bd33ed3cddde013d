#pragma once
/// \file
/// As if the machine had one core.

#include <filesystem>
#include <string>

#include <sched.h>

namespace holdfast::test {

/// All threads run on one core while this lives.
class OneCore {
 public:
  OneCore()
  {
    sched_getaffinity(0, sizeof(before_), &before_);
    int core = 0;
    while (!CPU_ISSET(core, &before_)) ++core;
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(core, &one);
    runOn(one);
  }
  ~OneCore() { runOn(before_); }
  OneCore(const OneCore&) = delete;
  OneCore& operator=(const OneCore&) = delete;

 private:
  static void runOn(const cpu_set_t& cores)
  {
    for (const auto& thread : std::filesystem::directory_iterator("/proc/self/task"))
      sched_setaffinity(std::stoi(thread.path().filename()), sizeof(cores), &cores);
  }

  cpu_set_t before_{};
};

}  // namespace holdfast::test
