#include "batch/progress_line.h"

#include <fmt/format.h>

#include "batch/standard_streams.h"

namespace holdfast::batch {

ProgressLine::ProgressLine() : thread_([this] { waitAndPrint(); }) {}

ProgressLine::~ProgressLine()
{
  {
    const std::lock_guard lock(mutex_);
    isDone_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void ProgressLine::step(std::string_view description)
{
  const std::lock_guard lock(mutex_);
  description_ = description;
  if (isLong_) print();
}

void ProgressLine::waitAndPrint()
{
  std::unique_lock lock(mutex_);
  if (changed_.wait_until(lock, start_ + std::chrono::seconds(1), [this] { return isDone_; })) return;
  isLong_ = true;
  if (!description_.empty()) print();
}

void ProgressLine::print() const
{
  const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  printMessage(fmt::format("[{:6.1f} s] {}\n", seconds, description_));
}

}  // namespace holdfast::batch
