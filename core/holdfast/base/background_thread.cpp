#include "holdfast/base/background_thread.h"

#include <atomic>
#include <list>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>

namespace holdfast {
namespace {

class BackgroundThreads {
 public:
  BackgroundThreads() = default;
  ~BackgroundThreads()
  {
    // A thread may start another one before it ends.
    for (;;) {
      std::unique_lock lock(mutex_);
      if (threads_.empty()) return;
      std::thread thread = std::move(threads_.back().thread);
      threads_.pop_back();
      lock.unlock();
      thread.join();
    }
  }
  BackgroundThreads(const BackgroundThreads&) = delete;
  BackgroundThreads& operator=(const BackgroundThreads&) = delete;

  void start(std::function<void()> work)
  {
    const std::scoped_lock lock(mutex_);
    threads_.remove_if([](Running& running) {
      if (!*running.hasEnded) return false;
      running.thread.join();
      return true;
    });
    auto hasEnded = std::make_shared<std::atomic<bool>>(false);
    std::thread thread([hasEnded, work = std::move(work)]() mutable {
      work();
      work = nullptr;
      *hasEnded = true;
    });
    threads_.push_back({std::move(thread), std::move(hasEnded)});
  }

 private:
  struct Running {
    std::thread thread;
    std::shared_ptr<const std::atomic<bool>> hasEnded;  // all that is left is to return
  };

  std::mutex mutex_;
  std::list<Running> threads_;
};

}  // namespace

void startBackgroundThread(std::function<void()> work)
{
  static BackgroundThreads threads;
  threads.start(std::move(work));
}

}  // namespace holdfast
