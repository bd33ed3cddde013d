#pragma once
/// How long work reports how far it is, and how it is stopped.

#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace holdfast {

/// Thrown by a `Progress` of a caller that wants the work to stop. Nothing has been changed when it arrives.
class Cancelled : public std::runtime_error {
 public:
  Cancelled() : std::runtime_error("cancelled") {}
};

/// Receives the steps of long work ("factorising 172,666 unknowns"). Called on the thread that works.
class Progress {
 public:
  virtual ~Progress() = default;

  /// May throw `Cancelled`.
  virtual void step(std::string_view description) = 0;

  /// Called again and again while a step that nothing can stop goes on elsewhere (`LongStep`), with the share of its
  /// operations that is done: 0 where that is not known. May throw `Cancelled`.
  virtual void proceed(double /*share*/) {}

 protected:
  Progress() = default;
  Progress(const Progress&) = default;
  Progress& operator=(const Progress&) = default;
};

/// Reports every step to `report`, with its share in whole percent where that is known, and stops the work once
/// `isUnwanted` returns true. Both are called on the thread that works.
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

/// "factorising 1000 unknowns, 40 %".
[[nodiscard]] std::string withPercent(std::string_view description, int percent);

/// Reports nothing.
class NoProgress final : public Progress {
 public:
  void step(std::string_view /*description*/) override {}
};

/// The default of functions that report their progress.
[[nodiscard]] inline Progress& noProgress()
{
  static NoProgress none;
  return none;
}

}  // namespace holdfast
