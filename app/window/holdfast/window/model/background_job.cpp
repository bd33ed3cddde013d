#include "holdfast/window/model/background_job.h"

#include <QCoreApplication>
#include <QEvent>
#include <utility>

#include <holdfast/threads/thread_priority.h>
#include <holdfast/window/text/number_text.h>

namespace holdfast {

void PostedCalls::post(Call call)
{
  const std::scoped_lock lock(mutex_);
  calls_.push_back(std::move(call));
  // Under the lock, so that the event too was made before its call is taken, after which it is deleted.
  QCoreApplication::postEvent(this, new QEvent(QEvent::User));
}

void PostedCalls::customEvent(QEvent* /*event*/)
{
  std::unique_lock lock(mutex_);
  const Call call = std::move(calls_.front());
  calls_.pop_front();
  lock.unlock();
  // The call may be the end of this object.
  call();
}

BackgroundJob::~BackgroundJob()
{
  // Earlier runs were asked for their end when the next one began. Calls that threads post meanwhile are dropped.
  stop_.request_stop();
}

void BackgroundJob::start(Work work)
{
  cancel();
  const std::uint64_t id = current_ = ++latest_;
  stop_ = std::stop_source();
  threads_.start([this, id, stop = stop_.get_token(), work = std::move(work)] {
    computeInBackground();
    StoppableProgress progress([&] { return stop.stop_requested(); },
                               [&](std::string_view step) {
                                 calls_.post([this, id, step = toText(step)] {
                                   if (id == current_) Q_EMIT stepChanged(step);
                                 });
                               });
    std::exception_ptr error;
    try {
      calls_.post([this, id, finish = work(progress)] {
        if (end(id) && finish) finish();
      });
    } catch (const Cancelled&) {
      calls_.post([this, id] { end(id); });
    } catch (...) {
      error = std::current_exception();
    }
    // Moved, so that the window's thread alone reads and releases it.
    if (error)
      calls_.post([this, id, error = std::move(error)] {
        if (end(id)) Q_EMIT failed(error);
      });
  });
}

void BackgroundJob::cancel()
{
  if (!isRunning()) return;
  stop_.request_stop();
  end(current_);
}

void BackgroundJob::wait()
{
  if (!isRunning()) return;
  threads_.waitForNewest();
  QCoreApplication::sendPostedEvents(&calls_, QEvent::User);
}

bool BackgroundJob::end(std::uint64_t run)
{
  if (run != current_) return false;
  current_ = 0;
  Q_EMIT ended();
  return true;
}

}  // namespace holdfast
