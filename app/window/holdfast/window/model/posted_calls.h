#pragma once
/// \file
/// How worker threads call functions on the thread of the window.

#include <QObject>
#include <deque>
#include <functional>
#include <mutex>

class QEvent;

namespace holdfast {

/// Calls posted by other threads run one by one, in their order, on the thread that this object lives on. Its
/// destructor drops those that are left.
///
/// A mutex of the standard library guards them, not Qt's queue of events: the thread sanitizer does not see the locks
/// of Qt, which is not built for it.
class PostedCalls final : public QObject {
 public:
  using Call = std::function<void()>;

  using QObject::QObject;

  /// From any thread, as long as this object lives.
  void post(Call call);

 protected:
  /// An event only signals that there is a call.
  void customEvent(QEvent* event) override;

 private:
  Call next();

  std::mutex mutex_;  // guards what follows, and the making of events
  std::deque<Call> calls_;
};

}  // namespace holdfast
