#include "holdfast/base/long_step.h"

#include <thread>

#include <holdfast/base/retired_threads.h>

namespace holdfast {
namespace {

/// Threads that go on although nobody waits for what they do.
std::atomic<int> leftBehind = 0;

constexpr std::chrono::milliseconds kLook{10};

}  // namespace

StepThread::~StepThread()
{
  if (state_ == nullptr) return;
  ++leftBehind;
  if (state_->exchange(State::LeftBehind) == State::Ended) --leftBehind;
}

void StepThread::start(std::function<void()> work, Progress& progress)
{
  for (; leftBehind > 1; std::this_thread::sleep_for(kLook)) progress.proceed();
  const auto state = std::make_shared<std::atomic<State>>(State::Running);
  const auto hasEnded = std::make_shared<std::atomic<bool>>(false);
  std::thread thread([state, hasEnded, work = std::move(work)]() mutable {
    work();
    work = nullptr;
    if (state->exchange(State::Ended) == State::LeftBehind) --leftBehind;
    *hasEnded = true;
  });
  state_ = state;
  retiredThreads().add(std::move(thread), hasEnded);
}

}  // namespace holdfast
