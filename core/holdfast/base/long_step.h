#pragma once
/// Work that cannot be stopped at any moment, such as a factorisation: the caller can stop waiting for it.

#include <atomic>
#include <chrono>
#include <exception>
#include <functional>
#include <future>
#include <memory>
#include <utility>

#include <holdfast/base/progress.h>

namespace holdfast {

/// Runs `work`, which does not throw, on a thread of its own. The thread may outlive its owner inside a factorisation:
/// the program waits for it at its end, so that none runs while its memory is torn down. Threads that have ended are
/// joined at the next call, so that a window that opens one mesh after another does not collect their stacks.
void startBackgroundThread(std::function<void()> work);

/// Thrown by work whose result is no longer wanted.
class LeftBehind : public std::exception {};

/// What the work of a step and those who wait for it tell each other. Any thread may call it.
class StepState {
 public:
  /// Whether the result is no longer wanted. To be asked now and then by work that can end early.
  [[nodiscard]] bool isLeftBehind() const noexcept { return phase_ == Phase::LeftBehind; }
  /// Throws `LeftBehind` then.
  void stopIfLeftBehind() const
  {
    if (isLeftBehind()) throw LeftBehind();
  }
  /// The share of the operations of the step, from 0 to 1.
  void setShare(double share) noexcept { share_ = share; }
  [[nodiscard]] double share() const noexcept { return share_; }

 private:
  friend class StepThread;
  enum class Phase { Running, Ended, LeftBehind };

  std::atomic<Phase> phase_ = Phase::Running;
  std::atomic<double> share_ = 0;
};

/// Of the step that the calling thread works for; of none, which runs, on another thread.
[[nodiscard]] std::shared_ptr<StepState> currentStep();

/// Runs one thing at most, on a thread of its own and to its end. Where this is destroyed earlier, the thread is left
/// behind: only the end of the program waits for it.
class StepThread {
 public:
  StepThread() = default;
  ~StepThread();
  StepThread(const StepThread&) = delete;
  StepThread& operator=(const StepThread&) = delete;

  /// Starts `work`, which does not throw. Waits until at most one thread that was left behind still runs, so that
  /// memory and cores are not used up. `progress` may throw meanwhile; nothing has been started then.
  void start(std::function<void()> work, Progress& progress);

  /// Of the work that was started.
  [[nodiscard]] double share() const noexcept { return state_->share(); }

 private:
  std::shared_ptr<StepState> state_;
};

/// One result that takes long. The work begins when it is asked for, or before, and holds all that it needs: it may
/// outlive this.
template <class Result>
class LongStep {
 public:
  template <class Work>
  explicit LongStep(Work work)
      : task_(std::make_shared<std::packaged_task<Result()>>(std::move(work))), result_(task_->get_future())
  {
  }

  [[nodiscard]] bool isDone() const { return result_.wait_for(std::chrono::seconds(0)) == std::future_status::ready; }

  /// Begins the work, if it has not begun, after a call of `prepare` on its thread. `progress` may throw; nothing has
  /// begun then.
  void start(Progress& progress, void (*prepare)() = nullptr)
  {
    const auto work = [task = task_, prepare] {
      if (prepare != nullptr) prepare();
      (*task)();
    };
    if (task_ != nullptr) thread_.start(work, progress);
    task_.reset();
  }

  /// Waits for the result; throws what the work throws. `progress` may throw meanwhile, within hundredths of a second:
  /// the work goes on then, and the next call waits for the rest of it.
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
