#pragma once
/// Threads that work beside the caller until their work ends.

#include <functional>
#include <future>
#include <mutex>
#include <vector>

namespace holdfast {

/// Runs each work on a thread of its own, and waits at its end for all of them. Any thread may call it.
class BackgroundThreads {
 public:
  BackgroundThreads() = default;
  ~BackgroundThreads();
  BackgroundThreads(const BackgroundThreads&) = delete;
  BackgroundThreads& operator=(const BackgroundThreads&) = delete;

  /// Starts `work`, which must not throw. Joins threads that have ended, so that their stacks do not collect.
  void start(std::function<void()> work);

  /// Waits for the newest thread that it still has. Returns false where it has none.
  bool waitForNewest();

 private:
  std::mutex mutex_;
  std::vector<std::future<void>> running_;  // of `std::async`: each waits at its end until its thread has ended
};

/// Runs `work`, which must not throw, on a thread that may outlive its owner inside a factorisation. The program waits
/// for the thread at its end, so that none runs while its memory is torn down.
void startBackgroundThread(std::function<void()> work);

}  // namespace holdfast
