#include "event_delays.h"

#include <QCoreApplication>
#include <QEvent>
#include <algorithm>

namespace holdfast::test {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kInterval{3};

struct Probe : QEvent {
  static Type type()
  {
    static const int kType = registerEventType();
    return static_cast<Type>(kType);
  }

  Probe() : QEvent(type()), posted(Clock::now()) {}

  Clock::time_point posted;
};

}  // namespace

EventDelays::EventDelays()
{
  static_cast<void>(Probe::type());
  poster_ = std::thread([this] {
    for (auto next = Clock::now(); !isStopping_; next += kInterval) {
      std::this_thread::sleep_until(next);
      QCoreApplication::postEvent(this, new Probe);
    }
  });
}

EventDelays::~EventDelays()
{
  stop();
}

void EventDelays::stop()
{
  isStopping_ = true;
  if (!poster_.joinable()) return;
  poster_.join();
  QCoreApplication::sendPostedEvents(this);
}

bool EventDelays::event(QEvent* event)
{
  if (event->type() != Probe::type()) return QObject::event(event);
  const auto waited = Clock::now() - static_cast<Probe*>(event)->posted;
  milliseconds_.push_back(std::chrono::duration<double, std::milli>(waited).count());
  return true;
}

double EventDelays::largest() const
{
  return quantile(1);
}

double EventDelays::quantile(double share) const
{
  if (milliseconds_.empty()) return 0;
  std::vector<double> sorted = milliseconds_;
  std::sort(sorted.begin(), sorted.end());
  return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

}  // namespace holdfast::test
