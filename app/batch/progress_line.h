#pragma once
/// \file
/// Progress on stderr, for work that takes longer than a second.

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

#include <holdfast/base/progress.h>

namespace holdfast::batch {

/// Says nothing in the first second; then prints the stage that is under way and each one that follows, with the
/// seconds since the start.
class ProgressLine final : public Progress {
 public:
  ProgressLine();
  ~ProgressLine() override;

  void step(std::string_view description) override;

 private:
  using Clock = std::chrono::steady_clock;

  void waitAndPrint();
  void print() const;

  Clock::time_point start_ = Clock::now();
  std::mutex mutex_;
  std::condition_variable changed_;
  std::string description_;
  bool isLong_ = false;
  bool isDone_ = false;
  std::thread thread_;
};

}  // namespace holdfast::batch
