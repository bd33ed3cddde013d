#pragma once
/// Runs work that takes long on a thread of its own, so that the window never waits. It also lets threads call the
/// window.

#include <QObject>
#include <QString>
#include <cstdint>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <stop_token>

#include <holdfast/threads/background_threads.h>
#include <holdfast/threads/progress.h>

namespace holdfast {

/// Runs calls that other threads post, in their order, on the thread that this object lives on. The destructor drops
/// the calls that are left. The class does not use Qt's queue of events for the calls: the thread sanitizer does not
/// see the locks of that queue.
class PostedCalls final : public QObject {
 public:
  using Call = std::function<void()>;

  using QObject::QObject;

  /// Adds a call. Any thread may post, as long as this object lives.
  void post(Call call);

 protected:
  void customEvent(QEvent* event) override;

 private:
  std::mutex mutex_;  // guards what follows, and the making of events
  std::deque<Call> calls_;
};

/// Runs one piece of work at a time; the newest one counts. The job lives on the thread of the window, where all
/// signals come.
class BackgroundJob : public QObject {
  Q_OBJECT

 public:
  /// The thread of the window calls this once the work has succeeded.
  using Finish = std::function<void()>;
  /// The work touches nothing of the window. It may throw. After `Cancelled` no signal comes but `ended`.
  using Work = std::function<Finish(Progress&)>;

  using QObject::QObject;
  /// Gives up the work under way, and waits for its current step.
  ~BackgroundJob() override;

  void start(Work work);
  /// Gives up the work under way, if any, at its next step. No signal or call follows but `ended`.
  void cancel();
  /// Waits until the work under way has ended and was reported.
  void wait();
  [[nodiscard]] bool isRunning() const noexcept { return current_ != 0; }

 Q_SIGNALS:
  void stepChanged(const QString& step);
  void ended();                                  ///< in whichever way, before `Finish` is called
  void failed(const std::exception_ptr& error);  ///< after `ended`

 private:
  /// Tells whether that run is the one that counts. If so, it does not count any more, and `ended` is emitted.
  bool end(std::uint64_t run);

  PostedCalls calls_;          // by the threads; outlives them
  std::uint64_t current_ = 0;  // the run that counts; 0 for none
  std::uint64_t latest_ = 0;
  std::stop_source stop_;  // of the newest run
  BackgroundThreads threads_;
};

}  // namespace holdfast
