#include "holdfast/window/model/posted_calls.h"

#include <QCoreApplication>
#include <QEvent>
#include <utility>

namespace holdfast {

void PostedCalls::post(Call call)
{
  const std::scoped_lock lock(mutex_);
  calls_.push_back(std::move(call));
  // Under the lock, so that the event too was made before `next` returns, after which it is deleted.
  QCoreApplication::postEvent(this, new QEvent(QEvent::User));
}

void PostedCalls::customEvent(QEvent* /*event*/)
{
  // The call may be the end of this object.
  const Call call = next();
  call();
}

PostedCalls::Call PostedCalls::next()
{
  const std::scoped_lock lock(mutex_);
  Call call = std::move(calls_.front());
  calls_.pop_front();
  return call;
}

}  // namespace holdfast
