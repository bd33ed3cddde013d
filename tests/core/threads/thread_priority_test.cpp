#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <pthread.h>
#include <sched.h>
#include <sys/resource.h>

#include <holdfast/threads/thread_priority.h>

namespace holdfast {
namespace {

using testing::Each;
using testing::SizeIs;

std::vector<int> coresOf(pthread_t thread)
{
  cpu_set_t set;
  CPU_ZERO(&set);
  if (::pthread_getaffinity_np(thread, sizeof(set), &set) != 0) return {};
  std::vector<int> cores;
  for (int core = 0; core < CPU_SETSIZE; ++core)
    if (CPU_ISSET(core, &set)) cores.push_back(core);
  return cores;
}

/// Threads of one name that wait until this ends.
class WaitingThreads {
 public:
  WaitingThreads(const char* name, std::size_t count)
  {
    for (std::size_t k = 0; k < count; ++k) {
      threads_.emplace_back([this] {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this] { return isOver_; });
      });
      ::pthread_setname_np(threads_.back().native_handle(), name);
    }
  }

  ~WaitingThreads()
  {
    {
      const std::scoped_lock lock(mutex_);
      isOver_ = true;
    }
    changed_.notify_all();
    for (std::thread& thread : threads_) thread.join();
  }

  WaitingThreads(const WaitingThreads&) = delete;
  WaitingThreads& operator=(const WaitingThreads&) = delete;

  [[nodiscard]] std::vector<std::vector<int>> cores()
  {
    std::vector<std::vector<int>> cores;
    for (std::thread& thread : threads_) cores.push_back(coresOf(thread.native_handle()));
    return cores;
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool isOver_ = false;
  std::vector<std::thread> threads_;
};

TEST(ThreadPriority, IsLoweredForTheThreadThatAsks)
{
  const auto niceness = [] { return ::getpriority(PRIO_PROCESS, 0); };
  const int before = niceness();
  std::thread([&] {
    computeInBackground();
    EXPECT_EQ(niceness(), std::min(before + 10, 19));
    computeInBackground();
    EXPECT_EQ(niceness(), std::min(before + 20, 19)) << "19 is as low as it goes";
  }).join();
  EXPECT_EQ(niceness(), before);
}

TEST(ThreadPriority, ThreadsOfANameAreSpreadOverTheCoresAndOthersAreNot)
{
  const std::vector<int> all = coresOf(::pthread_self());
  WaitingThreads drawing("draw-1", all.size());
  WaitingThreads other("other-1", 2);
  spreadOverCores("draw-");
  std::vector<std::vector<int>> found = drawing.cores();
  EXPECT_THAT(found, Each(SizeIs(1)));
  std::sort(found.begin(), found.end());
  EXPECT_EQ(std::unique(found.begin(), found.end()), found.end()) << "as many threads as cores: one each";
  EXPECT_THAT(other.cores(), Each(all));
  EXPECT_EQ(coresOf(::pthread_self()), all);
}

TEST(ThreadPriority, MoreThreadsThanCoresShareThem)
{
  WaitingThreads drawing("draw-2", coresOf(::pthread_self()).size() + 1);
  spreadOverCores("draw-");
  EXPECT_THAT(drawing.cores(), Each(SizeIs(1)));
}

}  // namespace
}  // namespace holdfast
