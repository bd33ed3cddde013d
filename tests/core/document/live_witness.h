#pragma once
/// \file
/// What a worker tells, and ways to hold it back where a test wants it, so that no test depends on timing.

#include <algorithm>
#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <holdfast/document/live_deformer.h>

#include "support/latch.h"

namespace holdfast::test {

/// A revision and how the work on it ended.
using End = std::pair<std::uint64_t, LiveEvent::Kind>;

/// A test holds the worker back at a gate: at the first event of this revision and kind, and with this message if it
/// says one.
struct Gate {
  std::uint64_t revision = 0;
  LiveEvent::Kind kind = LiveEvent::Kind::Started;
  std::string message;

  [[nodiscard]] bool isMetBy(const LiveEvent& event) const
  {
    return event.revision == revision && event.kind == kind && (message.empty() || event.message == message);
  }
};

/// What the worker says last before it solves.
inline const std::string kLastStep = "solving";

/// Takes down what the worker tells; stops it at a gate until it is opened.
class Witness {
 public:
  explicit Witness(std::optional<Gate> gate = std::nullopt) : gate_(std::move(gate)) {}

  [[nodiscard]] LiveDeformer::Listener listener()
  {
    return [this](const LiveEvent& event) { take(event); };
  }

  /// Tells whether the worker has come to the gate in time.
  [[nodiscard]] bool isAtGate() { return reached_.wait(); }
  void openGate() { gateway_.open(); }

  /// The events so far once the end of `revision` is among them; fails where it does not come in time.
  [[nodiscard]] std::vector<LiveEvent> eventsTo(std::uint64_t revision)
  {
    const bool hasCome = waitUntil([&] {
      return std::any_of(events_.begin(), events_.end(),
                         [&](const LiveEvent& event) { return event.revision == revision && isEnd(event); });
    });
    EXPECT_TRUE(hasCome) << "the end of revision " << revision;
    const std::scoped_lock lock(mutex_);
    return events_;
  }

  /// Tells whether the work on `revision` has come, in time, to a stage that begins so.
  [[nodiscard]] bool hasStep(std::uint64_t revision, std::string_view start)
  {
    return waitUntil([&] {
      return std::any_of(events_.begin(), events_.end(), [&](const LiveEvent& event) {
        return event.revision == revision && event.kind == LiveEvent::Kind::Step && event.message.starts_with(start);
      });
    });
  }

  /// The report of `revision` with all that is looked for at rest; null where it does not come in time. It is not among
  /// the events: it comes after some time.
  [[nodiscard]] std::shared_ptr<const Report> examined(std::uint64_t revision)
  {
    static_cast<void>(waitUntil(
        [&] { return reports_.contains(revision) && reports_.at(revision)->result.crossingFaces.has_value(); }));
    const std::scoped_lock lock(mutex_);
    return reports_[revision];
  }

  [[nodiscard]] std::vector<End> endsTo(std::uint64_t revision)
  {
    std::vector<End> ends;
    for (const LiveEvent& event : eventsTo(revision))
      if (isEnd(event)) ends.emplace_back(event.revision, event.kind);
    return ends;
  }

  [[nodiscard]] std::size_t count()
  {
    const std::scoped_lock lock(mutex_);
    return events_.size();
  }

  static bool isEnd(const LiveEvent& event) { return event.kind > LiveEvent::Kind::Iterate; }

 private:
  void take(const LiveEvent& event)
  {
    bool isAtGate = false;
    {
      const std::scoped_lock lock(mutex_);
      if (event.kind == LiveEvent::Kind::Examined) {
        reports_[event.revision] = event.report;
        return changed_.notify_all();
      }
      events_.push_back(event);
      events_.back().state = nullptr;  // its owner is to see when the worker lets go of it
      isAtGate = gate_ && gate_->isMetBy(event);
      if (isAtGate) gate_.reset();
      changed_.notify_all();
    }
    if (!isAtGate) return;
    reached_.open();
    EXPECT_TRUE(gateway_.wait());
  }

  template <class Condition>
  bool waitUntil(Condition condition)
  {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, kPatience, condition);
  }

  std::mutex mutex_;  // guards what follows
  std::condition_variable changed_;
  std::optional<Gate> gate_;
  std::vector<LiveEvent> events_;
  std::map<std::uint64_t, std::shared_ptr<const Report>> reports_;  // of results that were looked at

  Latch reached_;
  Latch gateway_;
};

}  // namespace holdfast::test
