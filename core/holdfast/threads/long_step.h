#pragma once
/// Work that cannot be stopped at any moment, such as a factorisation. The caller can stop waiting for it.

#include <atomic>
#include <chrono>
#include <exception>
#include <functional>
#include <future>
#include <memory>
#include <utility>

#include <holdfast/threads/progress.h>

namespace holdfast {

/// Work throws this when its result is no longer wanted.
class LeftBehind : public std::exception {};

/// The work of a step and those who wait for it tell each other their state here. Any thread may call it.
class StepState {
 public:
  /// Tells whether the result is no longer wanted. Work that can end early asks this now and then.
  [[nodiscard]] bool isLeftBehind() const noexcept { return phase_ == Phase::LeftBehind; }
  /// Throws `LeftBehind` where the result is no longer wanted.
  void stopIfLeftBehind() const
  {
    if (isLeftBehind()) throw LeftBehind();
  }
  /// Sets the share of the operations of the step that are done, from 0 to 1.
  void setShare(double share) noexcept { share_ = share; }
  [[nodiscard]] double share() const noexcept { return share_; }

 private:
  friend class StepThread;
  enum class Phase { Running, Ended, LeftBehind };

  std::atomic<Phase> phase_ = Phase::Running;
  std::atomic<double> share_ = 0;
};

/// Returns the state of the step that the calling thread works for. On another thread it returns that of no step, which
/// counts as running.
[[nodiscard]] std::shared_ptr<StepState> currentStep();

/// Runs one thing at most, on a thread of its own and to its end. When this object is destroyed earlier, the thread is
/// left behind. Then only the end of the program waits for it.
class StepThread {
 public:
  StepThread() = default;
  ~StepThread();
  StepThread(const StepThread&) = delete;
  StepThread& operator=(const StepThread&) = delete;

  /// Starts `work`, which must not throw. Waits until at most one thread that was left behind still runs, so that
  /// memory and cores are not used up. `progress` may throw meanwhile; then nothing has been started.
  void start(std::function<void()> work, Progress& progress);

  /// Returns the share of the work that was started.
  [[nodiscard]] double share() const noexcept { return state_->share(); }

 private:
  std::shared_ptr<StepState> state_;
};

/// A `LongStep` holds one result that takes long. The work begins when somebody asks for the result, or before. The
/// work holds all that it needs, because it may outlive the step.
template <class Result>
class LongStep {
 public:
  template <class Work>
  explicit LongStep(Work work)
      : task_(std::make_shared<std::packaged_task<Result()>>(std::move(work))), result_(task_->get_future())
  {
  }

  [[nodiscard]] bool isDone() const { return result_.wait_for(std::chrono::seconds(0)) == std::future_status::ready; }

  /// Begins the work, if it has not begun. It calls `prepare` on the work's thread first. `progress` may throw; then
  /// nothing has begun.
  void start(Progress& progress, void (*prepare)() = nullptr)
  {
    const auto work = [task = task_, prepare] {
      if (prepare != nullptr) prepare();
      (*task)();
    };
    if (task_ != nullptr) thread_.start(work, progress);
    task_.reset();
  }

  /// Waits for the result and throws what the work throws. `progress` may throw meanwhile, within hundredths of a
  /// second. Then the work goes on, and the next call waits for the rest of it.
  const Result& result(Progress& progress)
  {
    start(progress);
    while (result_.wait_for(kAnswer) != std::future_status::ready) progress.proceed(thread_.share());
    return result_.get();
  }

 private:
  static constexpr std::chrono::milliseconds kAnswer{10};

  std::shared_ptr<std::packaged_task<Result()>> task_;  // until it is started
  std::shared_future<Result> result_;
  StepThread thread_;
};

}  // namespace holdfast
