#pragma once
/// \file
/// How long work tells how far it is, and how it is stopped.

#include <stdexcept>
#include <string_view>

namespace holdfast {

/// Thrown by a `Progress` of a caller that wants the work to stop. Nothing has been changed when it arrives.
class Cancelled : public std::runtime_error {
 public:
  Cancelled() : std::runtime_error("cancelled") {}
};

/// Told at the start of each stage of long work ("factorising 172,666 unknowns"). Called on the thread that works.
class Progress {
 public:
  virtual ~Progress() = default;

  /// May throw `Cancelled`.
  virtual void step(std::string_view description) = 0;

  /// Called again and again while a step that nothing can stop goes on elsewhere (`LongStep`). May throw `Cancelled`.
  virtual void proceed() {}

 protected:
  Progress() = default;
  Progress(const Progress&) = default;
  Progress& operator=(const Progress&) = default;
};

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
