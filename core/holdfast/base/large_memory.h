#pragma once
/// Memory for many numbers.

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

namespace holdfast {

/// Keeps what is freed for what is taken next, in one heap for all threads: up to a third of a decomposition is to take
/// new pages. For the main function of a program that computes again and again.
void keepFreedMemory() noexcept;

/// Keeps the memory for another array of this size, but lets the system take it; frees it where `LeastMemory` lives.
struct FreePages {
  std::size_t bytes = 0;
  void operator()(double* numbers) const noexcept;
};

/// In pages of 2 MiB where the system has them: a walk through all of it would wait for the table of small pages.
using LargeArray = std::unique_ptr<double[], FreePages>;

/// Any numbers. New pages are taken where something is written first: that may cost more than to compute it.
[[nodiscard]] LargeArray largeArray(std::size_t count);

/// Arrays that come and go, on any threads. What is given back is taken again, the lowest place first, so that few
/// pages are ever written.
class ReusedMemory {
  struct GiveBack {
    ReusedMemory* memory = nullptr;
    std::size_t count = 0;
    void operator()(double* numbers) const { memory->giveBack(numbers, count); }
  };

 public:
  /// Any numbers. To be gone before the memory is.
  using Array = std::unique_ptr<double[], GiveBack>;

  /// Will have place for so many numbers at once, and takes more memory where they do not suffice.
  explicit ReusedMemory(std::size_t count) : regionSize_(count) {}

  /// O(gaps).
  [[nodiscard]] Array take(std::size_t count);

  /// Gives whole pages that are not taken back to the system while `LeastMemory` lives.
  void returnGaps();

 private:
  void giveBack(double* numbers, std::size_t count);

  std::size_t regionSize_;
  std::vector<LargeArray> regions_;
  std::map<double*, std::size_t> gaps_;  // sizes by places; none touches another
  std::mutex mutex_;
};

}  // namespace holdfast
