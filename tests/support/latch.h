#pragma once
/// \file
/// Holds threads back where a test wants it, so that no test depends on timing.

#include <chrono>
#include <condition_variable>
#include <mutex>

namespace holdfast::test {

/// After this long a test gives up waiting.
inline constexpr std::chrono::seconds kPatience{120};

/// Holds threads back until it is opened.
class Latch {
 public:
  /// Tells under the lock: who is told may take the latch down at once.
  void open()
  {
    const std::scoped_lock lock(mutex_);
    isOpen_ = true;
    changed_.notify_all();
  }

  /// Tells whether it was opened in time.
  [[nodiscard]] bool wait()
  {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, kPatience, [this] { return isOpen_; });
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool isOpen_ = false;
};

}  // namespace holdfast::test
