#include "holdfast/base/long_step.h"

#include <thread>

#include <holdfast/base/background_thread.h>

namespace holdfast {
namespace {

/// Threads that still run although their results are no longer needed.
std::atomic<int> leftBehind = 0;

constexpr std::chrono::milliseconds kLook{10};

thread_local std::function<bool()> isLeftBehind;

}  // namespace

std::function<bool()> leftBehindCheck()
{
  return isLeftBehind ? isLeftBehind : [] { return false; };
}

StepThread::~StepThread()
{
  if (state_ == nullptr) return;
  ++leftBehind;
  if (state_->exchange(State::LeftBehind) == State::Ended) --leftBehind;
}

void StepThread::start(std::function<void()> work, Progress& progress)
{
  for (; leftBehind > 1; std::this_thread::sleep_for(kLook)) progress.proceed();
  auto state = std::make_shared<std::atomic<State>>(State::Running);
  startBackgroundThread([state, work = std::move(work)]() mutable {
    isLeftBehind = [state] { return *state == State::LeftBehind; };
    work();
    work = nullptr;
    if (state->exchange(State::Ended) == State::LeftBehind) --leftBehind;
  });
  state_ = std::move(state);
}

}  // namespace holdfast
