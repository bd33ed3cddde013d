#pragma once
/// \file
/// What work costs: seconds, and how far the memory of the process grows.

#include <algorithm>
#include <chrono>
#include <limits>

namespace holdfast::bench {

/// Runs `work` once.
template <class Work>
[[nodiscard]] double secondsOf(const Work& work)
{
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// The shortest of `times` runs.
template <class Work>
[[nodiscard]] double shortest(int times, const Work& work)
{
  double seconds = std::numeric_limits<double>::infinity();
  for (int k = 0; k < times; ++k) seconds = std::min(seconds, secondsOf(work));
  return seconds;
}

/// Resident memory of the process since `startPeak`, at its highest, in MiB (Linux: VmHWM of /proc/self/status).
[[nodiscard]] double peakMiB();

/// Gives memory that is free back to the system and forgets the peak so far (Linux: /proc/self/clear_refs). Returns the
/// resident memory, from which the next peak starts.
double startPeak();

}  // namespace holdfast::bench
