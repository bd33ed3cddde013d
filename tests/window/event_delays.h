#pragma once
/// \file
/// How long events wait to be handled: what a user feels of a window.

#include <QObject>
#include <atomic>
#include <ctime>
#include <thread>
#include <vector>

namespace holdfast::test {

/// In milliseconds.
struct Quantiles {
  double half = 0;
  double ninetyNine = 0;  ///< of 100
  double largest = 0;
};

/// From its making on another thread posts events to this one, a few hundred a second whatever this one does, and each
/// takes down how long it has waited, and how long this thread has computed meanwhile: the rest of the time it was
/// others' turn, of this machine or of this program.
class EventDelays : public QObject {
 public:
  EventDelays();
  ~EventDelays() override;
  EventDelays(const EventDelays&) = delete;
  EventDelays& operator=(const EventDelays&) = delete;

  /// Posts no more, and handles what is under way.
  void stop();

  /// `stop` was called.
  [[nodiscard]] Quantiles waited() const;
  [[nodiscard]] Quantiles computed() const;
  [[nodiscard]] std::size_t count() const noexcept { return waited_.size(); }

 protected:
  bool event(QEvent* event) override;

 private:
  std::vector<double> waited_;
  std::vector<double> computed_;
  clockid_t computing_;  // the time that this object's thread has computed
  std::atomic<bool> isStopping_ = false;
  std::thread poster_;
};

}  // namespace holdfast::test
