#pragma once
/// Large memory holds many numbers.

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

namespace holdfast {

/// Keeps freed memory for what is taken next, in one heap for all threads. Taking new pages is up to a third of a
/// decomposition. The main function of a program that computes again and again calls this.
void keepFreedMemory() noexcept;

/// Keeps the memory for another array of this size, but lets the system take it. Frees it while a `LeastMemory` lives.
struct FreePages {
  std::size_t bytes = 0;
  void operator()(double* numbers) const noexcept;
};

/// An array in pages of 2 MiB where the system has them. With small pages, a walk through all of it would wait for
/// their table.
using LargeArray = std::unique_ptr<double[], FreePages>;

/// Makes an array that holds any numbers. New pages are taken where something is written first. That may cost more than
/// to compute it.
[[nodiscard]] LargeArray largeArray(std::size_t count);

/// Memory for arrays that come and go, on any threads. What is given back is taken again, the lowest place first. So
/// few pages are ever written.
class ReusedMemory {
  struct GiveBack {
    ReusedMemory* memory = nullptr;
    std::size_t count = 0;
    void operator()(double* numbers) const { memory->giveBack(numbers, count); }
  };

 public:
  /// An array that holds any numbers. It must be gone before the memory is.
  using Array = std::unique_ptr<double[], GiveBack>;

  /// Makes place for so many numbers at once. The memory takes more where that does not suffice.
  explicit ReusedMemory(std::size_t count) : regionSize_(count) {}

  /// Takes an array from the memory. O(gaps).
  [[nodiscard]] Array take(std::size_t count);

  /// Gives whole pages that are not in use back to the system while a `LeastMemory` lives.
  void returnGaps();

 private:
  void giveBack(double* numbers, std::size_t count);

  std::size_t regionSize_;
  std::vector<LargeArray> regions_;
  std::map<double*, std::size_t> gaps_;  // sizes by places; none touches another
  std::mutex mutex_;
};

}  // namespace holdfast
