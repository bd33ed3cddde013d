#include <atomic>
#include <thread>

#include <gtest/gtest.h>

#include <holdfast/threads/background_threads.h>

namespace holdfast {
namespace {

TEST(BackgroundThreads, AreWaitedForAtTheirEnd)
{
  std::atomic<bool> mayEnd = false;
  std::atomic<int> ended = 0;
  {
    BackgroundThreads threads;
    for (int k = 0; k < 3; ++k)
      threads.start([&] {
        mayEnd.wait(false);
        // Long enough for an owner who does not wait to be found out.
        for (int turn = 0; turn < 1000; ++turn) std::this_thread::yield();
        ++ended;
      });
    mayEnd = true;
    mayEnd.notify_all();
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
