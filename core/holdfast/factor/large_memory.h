#pragma once
/// Memory for many numbers.

#include <cstddef>
#include <cstdlib>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

namespace holdfast {

struct FreeNumbers {
  void operator()(double* numbers) const noexcept { std::free(numbers); }
};

/// In pages of 2 MiB where the system has them: a walk through all of it would wait for the table of small pages.
using LargeArray = std::unique_ptr<double[], FreeNumbers>;

/// Any numbers. Pages are taken when something is written to them.
[[nodiscard]] LargeArray largeArray(std::size_t count);

/// Arrays that come and go, on any threads. What is given back is taken again, the lowest place first, so that few pages
/// are ever written: to take a page costs more than to compute what comes into it.
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

 private:
  void giveBack(double* numbers, std::size_t count);

  std::size_t regionSize_;
  std::vector<LargeArray> regions_;
  std::map<double*, std::size_t> gaps_;  // sizes by places; none touches another
  std::mutex mutex_;
};

}  // namespace holdfast
