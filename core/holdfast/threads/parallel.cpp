#include "holdfast/threads/parallel.h"

#include <atomic>
#include <cfenv>
#include <memory>
#include <system_error>
#include <thread>
#include <utility>

namespace holdfast {
namespace {

/// A thread that waits for work: to start one takes as long as the loops of a small mesh.
class Helper {
 public:
  Helper() : thread_([this] { serve(); }) {}
  ~Helper()
  {
    wait();
    hand(nullptr);
    thread_.join();
  }
  Helper(const Helper&) = delete;
  Helper& operator=(const Helper&) = delete;

  /// It computes as the calling thread does (`NoSubnormals`).
  void start(const ThreadWork& work, Index thread)
  {
    std::fegetenv(&arithmetic_);
    number_ = thread;
    hand(&work);
  }

  void wait() const { isHanded_.wait(true, std::memory_order_acquire); }

 private:
  void hand(const ThreadWork* work)
  {
    work_ = work;
    isHanded_.store(true, std::memory_order_release);
    isHanded_.notify_one();
  }

  void serve()
  {
    for (;;) {
      isHanded_.wait(false, std::memory_order_acquire);
      if (work_ == nullptr) return;
      std::fesetenv(&arithmetic_);
      (*work_)(number_);
      isHanded_.store(false, std::memory_order_release);
      isHanded_.notify_one();
    }
  }

  std::atomic<bool> isHanded_ = false;  // says whose the others are
  const ThreadWork* work_ = nullptr;
  Index number_ = 0;
  std::fenv_t arithmetic_{};
  std::thread thread_;
};

using Helpers = std::vector<std::unique_ptr<Helper>>;

/// The helpers of the calling thread that have no work: the turns of a loop may have loops of their own.
thread_local Helpers idle;

std::unique_ptr<Helper> idleHelper()
{
  if (idle.empty()) return std::make_unique<Helper>();
  std::unique_ptr<Helper> helper = std::move(idle.back());
  idle.pop_back();
  return helper;
}

}  // namespace

void runOnThreads(Index count, const ThreadWork& work)
{
  Helpers helpers;
  try {
    while (static_cast<Index>(helpers.size()) + 1 < count) {
      helpers.push_back(idleHelper());
      helpers.back()->start(work, static_cast<Index>(helpers.size()));
    }
  } catch (const std::system_error&) {  // no more threads are to be had: those that run do all
  }
  work(0);
  for (std::unique_ptr<Helper>& helper : helpers) {
    helper->wait();
    idle.push_back(std::move(helper));
  }
}

}  // namespace holdfast
