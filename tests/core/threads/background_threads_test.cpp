#include <atomic>
#include <chrono>
#include <thread>

#include <gtest/gtest.h>

#include <holdfast/threads/background_threads.h>

namespace holdfast {
namespace {

TEST(BackgroundThreads, AreWaitedForAtTheirEnd)
{
  std::atomic<int> ended = 0;
  {
    BackgroundThreads threads;
    for (int k = 0; k < 3; ++k)
      threads.start([&ended] {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        ++ended;
      });
  }
  EXPECT_EQ(ended, 3);
}

TEST(BackgroundThreads, CanBeWaitedForFromTheNewestOn)
{
  std::atomic<bool> mayEnd = false;
  std::atomic<bool> isNewestDone = false;
  BackgroundThreads threads;
  EXPECT_FALSE(threads.waitForNewest());
  threads.start([&mayEnd] { mayEnd.wait(false); });
  threads.start([&isNewestDone] { isNewestDone = true; });
  EXPECT_TRUE(threads.waitForNewest());
  EXPECT_TRUE(isNewestDone);
  mayEnd = true;
  mayEnd.notify_one();
  EXPECT_TRUE(threads.waitForNewest());
  EXPECT_FALSE(threads.waitForNewest());
}

}  // namespace
}  // namespace holdfast
