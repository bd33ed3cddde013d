#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <holdfast/threads/parallel.h>

namespace holdfast {
namespace {

TEST(ParallelFor, TakesEveryTurnOnceInLoopsWithinLoops)
{
  constexpr Index kTurns = 50;
  std::vector<std::atomic<int>> taken(static_cast<std::size_t>(kTurns * kTurns));
  parallelFor(kTurns, [&](Index i) { parallelFor(kTurns, [&](Index k) { ++taken[i * kTurns + k]; }); });
  EXPECT_TRUE(std::ranges::all_of(taken, [](int count) { return count == 1; }));
}

TEST(ParallelFor, NumbersItsThreadsAndKeepsThem)
{
  static std::atomic<Index> threads = 0;
  thread_local bool isCounted = false;
  std::atomic<bool> areNumbered = true;
  for (int loop = 0; loop < 200; ++loop)
    parallelFor(64, [&](Index, Index thread) {
      if (!std::exchange(isCounted, true)) ++threads;
      if (thread < 0 || thread >= threadCount()) areNumbered = false;
    });
  EXPECT_LE(threads, threadCount());
  EXPECT_TRUE(areNumbered);
}

TEST(ParallelFor, ThrowsAfterAllThreadsHaveEndedAndGoesOnInTheNextLoop)
{
  for (int loop = 0; loop < 100; ++loop) {
    std::atomic<int> under = 0;
    EXPECT_THROW(parallelFor(64,
                             [&](Index k) {
                               ++under;
                               std::this_thread::yield();
                               --under;
                               if (k == 7) throw std::runtime_error("turn 7");
                             }),
                 std::runtime_error);
    EXPECT_EQ(under, 0);
  }
  std::atomic<Index> sum = 0;
  parallelFor(64, [&](Index k) { sum += k; });
  EXPECT_EQ(sum, 63 * 64 / 2);
}

TEST(ParallelFor, WorksOnThreadsThatComeAndGo)
{
  std::atomic<Index> sum = 0;
  for (int k = 0; k < 50; ++k) std::jthread([&] { parallelFor(8, [&](Index turn) { sum += turn; }); }).join();
  EXPECT_EQ(sum, 50 * 28);
}

TEST(LeadSteps, LeadsAfterAllPartsOfTheStepBeforeAndSharesEachPartOnce)
{
  constexpr Index kSteps = 300;
  const auto partCount = [](Index step) { return step % 7; };
  std::vector<int> led;
  std::vector<std::atomic<int>> taken(7 * kSteps);
  std::atomic<Index> shared = 0;
  Index expected = 0;
  std::atomic<bool> isInOrder = true;
  const std::thread::id caller = std::this_thread::get_id();
  leadSteps(
      kSteps,
      [&](Index step) {
        if (shared != expected || std::this_thread::get_id() != caller) isInOrder = false;
        expected += partCount(step);
        led.push_back(static_cast<int>(step));
      },
      partCount,
      [&](Index step, Index part) {
        if (led.back() != step) isInOrder = false;
        ++taken[7 * step + part];
        ++shared;
      });
  EXPECT_TRUE(isInOrder);
  EXPECT_EQ(led.size(), kSteps);
  for (Index step = 0; step < kSteps; ++step)
    for (Index part = 0; part < 7; ++part) EXPECT_EQ(taken[7 * step + part], part < partCount(step) ? 1 : 0);
}

}  // namespace
}  // namespace holdfast
