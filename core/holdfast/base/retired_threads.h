#pragma once
/// \file
/// Threads that nobody waits for any more, but the program at its end.

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace holdfast {

/// Threads whose owners are gone may still be inside a factorisation: the program waits for them at its end, so that
/// none runs while its memory is torn down.
class RetiredThreads {
 public:
  RetiredThreads() = default;
  ~RetiredThreads();
  RetiredThreads(const RetiredThreads&) = delete;
  RetiredThreads& operator=(const RetiredThreads&) = delete;

  /// `hasEnded` becomes true when all that is left of the thread is to return. Joins those that have come to that, so
  /// that a window that opens one mesh after another does not collect their stacks.
  void add(std::thread thread, std::shared_ptr<const std::atomic<bool>> hasEnded);

 private:
  struct Retired {
    std::thread thread;
    std::shared_ptr<const std::atomic<bool>> hasEnded;
  };

  [[nodiscard]] std::optional<std::thread> takeOne();

  std::mutex mutex_;
  std::vector<Retired> threads_;
};

/// Those of the program. Who wants them to outlive an object calls this before making it.
[[nodiscard]] RetiredThreads& retiredThreads();

}  // namespace holdfast
