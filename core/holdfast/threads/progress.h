#pragma once
/// Long work reports through these classes how far it is, and its caller stops it through them.

#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace holdfast {

/// The caller's `Progress` throws this when the caller wants the work to stop. Nothing has been changed when it
/// arrives.
class Cancelled : public std::runtime_error {
 public:
  Cancelled() : std::runtime_error("cancelled") {}
};

/// A `Progress` receives the steps of long work ("factorising 172,666 unknowns"). The thread that works calls it.
class Progress {
 public:
  virtual ~Progress() = default;

  /// The work calls this at the beginning of each step. The function may throw `Cancelled`.
  virtual void step(std::string_view description) = 0;

  /// A step that nothing can stop goes on elsewhere (`LongStep`). Meanwhile this is called again and again. `share` is
  /// how much of the operations of the step is done, 0 where that is not known. The function may throw `Cancelled`.
  virtual void proceed(double /*share*/) {}

 protected:
  Progress() = default;
  Progress(const Progress&) = default;
  Progress& operator=(const Progress&) = default;
};

/// This progress reports every step to `report`, with its share in whole percent where that is known. It stops the work
/// once `isUnwanted` returns true. The thread that works calls both.
///
///     std::atomic<bool> isStopped = false;  // another thread sets it
///     StoppableProgress progress([&] { return isStopped.load(); }, [](std::string_view step) { show(step); });
///     try {
///       show(deform(model, constraints, "constraints", {}, progress).positions);
///     } catch (const Cancelled&) {
///       show("stopped; nothing has changed");
///     }
class StoppableProgress final : public Progress {
 public:
  StoppableProgress(std::function<bool()> isUnwanted, std::function<void(std::string_view)> report)
      : isUnwanted_(std::move(isUnwanted)), report_(std::move(report))
  {
  }

  void step(std::string_view description) override;
  void proceed(double share) override;

 private:
  std::function<bool()> isUnwanted_;
  std::function<void(std::string_view)> report_;
  std::string description_;
  int percent_ = 0;
};

/// Returns the text that `StoppableProgress` reports: "factorising 1000 unknowns, 40 %".
[[nodiscard]] std::string withPercent(std::string_view description, int percent);

/// This progress reports nothing and never stops the work.
class NoProgress final : public Progress {
 public:
  void step(std::string_view /*description*/) override {}
};

/// Functions that report their progress take this one by default.
[[nodiscard]] inline Progress& noProgress()
{
  static NoProgress none;
  return none;
}

}  // namespace holdfast
