#pragma once
/// \file
/// What a piece of work costs: seconds, and how far the memory of the process grew while it ran.

#include <chrono>
#include <type_traits>
#include <utility>

namespace holdfast::bench {

struct Cost {
  double seconds = 0;
  double peakMiB = 0;  ///< resident memory at its highest during the work, less that before; NaN where not known
};

template <class Result>
struct Measured {
  Result result;
  Cost cost;
};

/// Resident memory of the process since `startPeak`, at its highest, in MiB (Linux: VmHWM of /proc/self/status).
[[nodiscard]] double peakMiB();

/// Gives memory that is free back to the system and forgets the peak so far (Linux: /proc/self/clear_refs). Returns the
/// resident memory, from which the next peak starts.
double startPeak();

/// Runs `work` once.
template <class Work>
[[nodiscard]] Measured<std::invoke_result_t<Work>> measure(Work&& work)
{
  using Clock = std::chrono::steady_clock;
  const double before = startPeak();
  const Clock::time_point start = Clock::now();
  auto result = std::forward<Work>(work)();
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return {std::move(result), {seconds, peakMiB() - before}};
}

}  // namespace holdfast::bench
