#include "holdfast/threads/background_threads.h"

#include <chrono>
#include <utility>

namespace holdfast {

BackgroundThreads::~BackgroundThreads()
{
  while (waitForNewest()) {
  }
}

void BackgroundThreads::start(std::function<void()> work)
{
  const std::scoped_lock lock(mutex_);
  std::erase_if(running_, [](const std::future<void>& thread) {
    return thread.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  });
  running_.push_back(std::async(std::launch::async, [work = std::move(work)]() mutable {
    work();
    work = nullptr;  // the future would keep it
  }));
}

bool BackgroundThreads::waitForNewest()
{
  std::unique_lock lock(mutex_);
  if (running_.empty()) return false;
  const std::future<void> newest = std::move(running_.back());
  running_.pop_back();
  lock.unlock();  // a thread may start another one before it ends
  return true;
}

void startBackgroundThread(std::function<void()> work)
{
  static BackgroundThreads threads;
  threads.start(std::move(work));
}

}  // namespace holdfast
