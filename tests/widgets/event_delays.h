#pragma once
/// \file
/// How long events wait to be handled: what a user feels of a window.

#include <QObject>
#include <atomic>
#include <chrono>
#include <string>
#include <thread>
#include <vector>

namespace holdfast::test {

/// From its making on another thread posts events to this one, a few hundred a second whatever this one does, and each
/// takes down how long it has waited.
class EventDelays : public QObject {
 public:
  EventDelays();
  ~EventDelays() override;
  EventDelays(const EventDelays&) = delete;
  EventDelays& operator=(const EventDelays&) = delete;

  /// Posts no more, and handles what is under way.
  void stop();

  /// Milliseconds. `stop` was called.
  [[nodiscard]] double largest() const;
  /// That which `share` of the events do not exceed.
  [[nodiscard]] double quantile(double share) const;
  [[nodiscard]] std::size_t count() const noexcept { return milliseconds_.size(); }

 protected:
  bool event(QEvent* event) override;

 private:
  std::vector<double> milliseconds_;
  std::atomic<bool> isStopping_ = false;
  std::thread poster_;
};

}  // namespace holdfast::test
