#pragma once
/// Loops over all cores. Their turns do not depend on one another.

#include <algorithm>
#include <atomic>
#include <exception>
#include <functional>
#include <thread>
#include <type_traits>
#include <vector>

#include <holdfast/numbers/types.h>

namespace holdfast {

/// Returns how many threads work at the same time, at most: one for each core, but no more than a few. More find no
/// more memory to read.
[[nodiscard]] inline Index threadCount()
{
  constexpr Index kMost = 8;
  static const Index kCount = std::clamp<Index>(static_cast<Index>(std::thread::hardware_concurrency()), 1, kMost);
  return kCount;
}

using ThreadWork = std::function<void(Index thread)>;

/// Calls `work`, which must not throw, on up to `count` threads. The calling thread is number 0. It has the others for
/// this as long as it lives. They have the priority that it had when they were first needed.
void runOnThreads(Index count, const ThreadWork& work);

/// Calls `work(k)`, or `work(k, thread)`, once for each k of 0 .. count - 1, on up to `threadCount()` threads. The
/// calling thread is number 0. Which thread takes which k is left open: results must not depend on it. Throws one of
/// the exceptions of `work`, after all threads have ended.
template <class Work>
void parallelFor(Index count, const Work& work)
{
  const Index threadsInAll = std::max<Index>(1, std::min(threadCount(), count));
  std::atomic<Index> next{0};
  std::vector<std::exception_ptr> errors(static_cast<std::size_t>(threadsInAll));
  const auto run = [&](Index thread) {
    try {
      for (Index k = next++; k < count; k = next++)
        if constexpr (std::is_invocable_v<Work, Index, Index>)
          work(k, thread);
        else
          work(k);
    } catch (...) {
      errors[thread] = std::current_exception();
      next = count;
    }
  };
  if (threadsInAll > 1)
    runOnThreads(threadsInAll, run);
  else
    run(0);
  for (const std::exception_ptr& error : errors)
    if (error) std::rethrow_exception(error);
}

/// Does what `parallelFor` does, for turns that take less time than it takes to hand them out.
template <class Work>
void parallelBlocks(Index count, const Work& work)
{
  constexpr Index kBlock = 4096;
  parallelFor((count + kBlock - 1) / kBlock, [&](Index block) {
    for (Index k = block * kBlock; k < std::min(count, (block + 1) * kBlock); ++k) work(k);
  });
}

/// Takes steps one after the other. It calls `lead(step)` on the calling thread. Then it calls `share(step, part)`,
/// once for each of `partCount(step)` parts, on all threads. It is for steps of microseconds. Threads do not sleep
/// until the next step, and none waits for another that has not taken a part. Nothing may throw.
template <class Lead, class PartCount, class Share>
void leadSteps(Index steps, const Lead& lead, const PartCount& partCount, const Share& share)
{
  std::atomic<Index> led{0};
  std::vector<std::atomic<Index>> taken(static_cast<std::size_t>(steps));
  std::vector<std::atomic<Index>> done(taken.size());
  const auto waitUntil = [](const auto& isSo) {
    constexpr int kTries = 2000;
    for (int tries = 0; !isSo(); ++tries)
      if (tries > kTries) std::this_thread::yield();
  };
  runOnThreads(threadCount(), [&](Index thread) {
    for (Index step = 0; step < steps; ++step) {
      if (thread == 0) {
        lead(step);
        led = step + 1;
      } else {
        waitUntil([&] { return led > step; });
      }
      for (Index part = taken[step]++; part < partCount(step); part = taken[step]++) {
        share(step, part);
        ++done[step];
      }
      if (thread == 0) waitUntil([&] { return done[step] == partCount(step); });
    }
  });
}

}  // namespace holdfast
