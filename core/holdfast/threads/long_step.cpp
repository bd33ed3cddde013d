#include "holdfast/threads/long_step.h"

#include <thread>

#include <holdfast/threads/background_threads.h>

namespace holdfast {
namespace {

/// Threads that still run although their results are no longer needed.
std::atomic<int> leftBehind = 0;

constexpr std::chrono::milliseconds kLook{10};

thread_local std::shared_ptr<StepState> current;

}  // namespace

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
