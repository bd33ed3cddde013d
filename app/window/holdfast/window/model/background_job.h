#pragma once
/// \file
/// Work that takes long, on a thread of its own, so that the window never waits.

#include <QObject>
#include <QString>
#include <exception>
#include <functional>
#include <memory>
#include <vector>

#include <holdfast/base/progress.h>
#include <holdfast/window/model/posted_calls.h>

namespace holdfast {

/// One piece of work at a time, of which the newest counts. Lives on the thread of the window, where all signals come.
class BackgroundJob : public QObject {
  Q_OBJECT

 public:
  /// What is left to be done on the thread of the window once the work has succeeded.
  using Finish = std::function<void()>;
  /// Runs on the job's thread, and touches nothing of the window's. May throw; `Cancelled` ends it without a word.
  using Work = std::function<Finish(Progress&)>;

  explicit BackgroundJob(QObject* parent = nullptr);
  /// Gives up the work under way, and waits for the stage that it is in.
  ~BackgroundJob() override;

  /// Gives up the work under way in favour of `work`.
  void start(Work work);
  /// Gives up the work under way at its next stage; nothing is heard of it any more. Harmless without any.
  void cancel();
  [[nodiscard]] bool isRunning() const noexcept { return current_ != nullptr; }

 Q_SIGNALS:
  void started();
  void stepChanged(const QString& step);
  void ended();                                  ///< in whichever way, before `Finish` is called
  void failed(const std::exception_ptr& error);  ///< after `ended`

 private:
  struct Run;

  void finish(const std::shared_ptr<Run>& run, const Finish& finish);
  void fail(const std::shared_ptr<Run>& run, const std::exception_ptr& error);
  bool end(const std::shared_ptr<Run>& run);
  void joinEnded();

  PostedCalls calls_;                       // by the threads; outlives them
  std::shared_ptr<Run> current_;            // the one that counts; null where none does
  std::vector<std::shared_ptr<Run>> runs_;  // all whose threads are not joined yet
};

}  // namespace holdfast
