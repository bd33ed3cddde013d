#include "holdfast/window/model/background_job.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>
#include <utility>

#include <holdfast/base/thread_priority.h>

namespace holdfast {

struct BackgroundJob::Run {
  std::atomic<bool> isUnwanted = false;
  std::atomic<bool> hasEnded = false;
  std::thread thread;
};

namespace {

/// Tells the window the stages of one run, and ends the work when nobody wants it.
class ProgressReporter final : public Progress {
 public:
  ProgressReporter(const std::atomic<bool>& isUnwanted, std::function<void(const QString&)> tell)
      : isUnwanted_(isUnwanted), tell_(std::move(tell))
  {
  }

  void step(std::string_view description) override
  {
    if (isUnwanted_) throw Cancelled();
    tell_(QString::fromUtf8(description.data(), static_cast<int>(description.size())));
  }

 private:
  const std::atomic<bool>& isUnwanted_;
  std::function<void(const QString&)> tell_;
};

}  // namespace

BackgroundJob::BackgroundJob(QObject* parent) : QObject(parent) {}

BackgroundJob::~BackgroundJob()
{
  // What the threads have posted meanwhile goes with this object.
  for (const auto& run : runs_) run->isUnwanted = true;
  for (const auto& run : runs_) run->thread.join();
}

void BackgroundJob::start(Work work)
{
  cancel();
  joinEnded();
  const auto run = std::make_shared<Run>();
  current_ = run;
  runs_.push_back(run);
  run->thread = std::thread([this, run = run.get(), weak = std::weak_ptr(run), work = std::move(work)] {
    computeInBackground();
    ProgressReporter progress(run->isUnwanted, [&](const QString& step) {
      calls_.post([this, weak, step] {
        if (current_ != nullptr && current_ == weak.lock()) Q_EMIT stepChanged(step);
      });
    });
    std::exception_ptr error;
    try {
      calls_.post([this, weak, result = work(progress)] { finish(weak.lock(), result); });
    } catch (const Cancelled&) {
      calls_.post([this, weak] { end(weak.lock()); });
    } catch (...) {
      error = std::current_exception();
    }
    // Handed over whole: who reads it is who lets it go.
    if (error) calls_.post([this, weak, error = std::move(error)] { fail(weak.lock(), error); });
    run->hasEnded = true;
  });
  Q_EMIT started();
}

void BackgroundJob::cancel()
{
  if (current_ == nullptr) return;
  current_->isUnwanted = true;
  current_.reset();
  Q_EMIT ended();
}

bool BackgroundJob::end(const std::shared_ptr<Run>& run)
{
  joinEnded();
  if (run == nullptr || run != current_) return false;
  current_.reset();
  Q_EMIT ended();
  return true;
}

void BackgroundJob::finish(const std::shared_ptr<Run>& run, const Finish& finish)
{
  if (end(run) && finish) finish();
}

void BackgroundJob::fail(const std::shared_ptr<Run>& run, const std::exception_ptr& error)
{
  if (end(run)) Q_EMIT failed(error);
}

void BackgroundJob::joinEnded()
{
  const auto ended = std::stable_partition(runs_.begin(), runs_.end(), [](const auto& run) { return !run->hasEnded; });
  std::for_each(ended, runs_.end(), [](const auto& run) { run->thread.join(); });
  runs_.erase(ended, runs_.end());
}

}  // namespace holdfast
