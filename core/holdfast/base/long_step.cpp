#include "holdfast/base/long_step.h"

#include <mutex>
#include <thread>
#include <vector>

namespace holdfast {
namespace {

/// Futures of `std::async`: each waits at its end until its thread has ended.
struct BackgroundThreads {
  ~BackgroundThreads()
  {
    for (;;) {
      std::unique_lock lock(mutex);
      if (running.empty()) return;
      const std::future<void> last = std::move(running.back());
      running.pop_back();
      lock.unlock();  // a thread may start another one before it ends
    }
  }

  std::mutex mutex;
  std::vector<std::future<void>> running;
};

/// Threads that still run although their results are no longer needed.
std::atomic<int> leftBehind = 0;

constexpr std::chrono::milliseconds kLook{10};

thread_local std::shared_ptr<StepState> current;

}  // namespace

void startBackgroundThread(std::function<void()> work)
{
  static BackgroundThreads threads;
  const std::scoped_lock lock(threads.mutex);
  std::erase_if(threads.running, [](const std::future<void>& thread) {
    return thread.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  });
  threads.running.push_back(std::async(std::launch::async, [work = std::move(work)]() mutable {
    work();
    work = nullptr;  // the future would keep it
  }));
}

std::shared_ptr<StepState> currentStep()
{
  return current != nullptr ? current : std::make_shared<StepState>();
}

StepThread::~StepThread()
{
  if (state_ == nullptr) return;
  ++leftBehind;
  if (state_->phase_.exchange(StepState::Phase::LeftBehind) == StepState::Phase::Ended) --leftBehind;
}

void StepThread::start(std::function<void()> work, Progress& progress)
{
  for (; leftBehind > 1; std::this_thread::sleep_for(kLook)) progress.proceed(0);
  auto state = std::make_shared<StepState>();
  startBackgroundThread([state, work = std::move(work)]() mutable {
    current = state;
    work();
    work = nullptr;
    if (state->phase_.exchange(StepState::Phase::Ended) == StepState::Phase::LeftBehind) --leftBehind;
  });
  state_ = std::move(state);
}

}  // namespace holdfast
