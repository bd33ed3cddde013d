#pragma once
/// \file
/// How the threads of workers speak to the thread of the window.

#include <QObject>
#include <deque>
#include <functional>
#include <mutex>

class QEvent;

namespace holdfast {

/// Calls that other threads leave, made one by one, in their order, on the thread that this object lives on. Those that
/// are left when it goes are dropped.
///
/// What a call carries is handed over under a mutex of the standard library and not in an event of Qt: the thread
/// sanitizer knows the one and is blind for the other, whose library is not built for it.
class PostedCalls final : public QObject {
 public:
  using Call = std::function<void()>;

  using QObject::QObject;

  /// From any thread, as long as this object lives.
  void post(Call call);

 protected:
  /// An event is only the sign that a call is there: it was made by another thread, and is not looked at.
  void customEvent(QEvent* event) override;

 private:
  Call next();

  std::mutex mutex_;  // guards what follows, and the making of events
  std::deque<Call> calls_;
};

}  // namespace holdfast
