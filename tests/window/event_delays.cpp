#include "event_delays.h"

#include <QCoreApplication>
#include <QEvent>
#include <algorithm>
#include <chrono>
#include <system_error>

#include <pthread.h>

namespace holdfast::test {
namespace {

constexpr std::chrono::milliseconds kInterval{3};

double milliseconds(clockid_t clock)
{
  timespec time{};
  if (::clock_gettime(clock, &time) != 0) throw std::system_error(errno, std::generic_category(), "clock_gettime");
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

struct Probe : QEvent {
  static Type type()
  {
    static const int kType = registerEventType();
    return static_cast<Type>(kType);
  }

  explicit Probe(clockid_t computing)
      : QEvent(type()), posted(milliseconds(CLOCK_MONOTONIC)), computed(milliseconds(computing))
  {
  }

  double posted;
  double computed;
};

Quantiles quantiles(std::vector<double> values)
{
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
  };
  return {at(0.5), at(0.99), at(1)};
}

}  // namespace

EventDelays::EventDelays()
{
  if (const int error = ::pthread_getcpuclockid(::pthread_self(), &computing_))
    throw std::system_error(error, std::generic_category(), "pthread_getcpuclockid");
  static_cast<void>(Probe::type());
  poster_ = std::thread([this] {
    for (auto next = std::chrono::steady_clock::now(); !isStopping_; next += kInterval) {
      std::this_thread::sleep_until(next);
      QCoreApplication::postEvent(this, new Probe(computing_));
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
  const auto* probe = static_cast<Probe*>(event);
  waited_.push_back(milliseconds(CLOCK_MONOTONIC) - probe->posted);
  computed_.push_back(milliseconds(computing_) - probe->computed);
  return true;
}

Quantiles EventDelays::waited() const
{
  return quantiles(waited_);
}

Quantiles EventDelays::computed() const
{
  return quantiles(computed_);
}

}  // namespace holdfast::test
