#include "holdfast/memory/large_memory.h"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <new>

#include <malloc.h>
#include <sys/mman.h>

#include <holdfast/memory/available_memory.h>

namespace holdfast {
namespace {

constexpr std::size_t kPage = std::size_t{2} << 20U;

/// Memory of arrays that are gone.
class Spares {
 public:
  /// Null where there is none of this size.
  double* take(std::size_t bytes)
  {
    const std::scoped_lock lock(mutex_);
    const auto spare = std::ranges::find(spares_, bytes, &Spare::bytes);
    if (spare == spares_.end()) return nullptr;
    double* const numbers = spare->numbers;
    spares_.erase(spare);
    return numbers;
  }

  void keep(std::size_t bytes, double* numbers)
  {
    ::madvise(numbers, bytes, MADV_FREE);
    const std::scoped_lock lock(mutex_);
    spares_.push_back({bytes, numbers});
    if (spares_.size() <= kMost) return;
    std::free(spares_.front().numbers);
    spares_.erase(spares_.begin());
  }

 private:
  struct Spare {
    std::size_t bytes;
    double* numbers;
  };

  static constexpr std::size_t kMost = 4;  // two factors, and the fronts of two

  std::vector<Spare> spares_;  // the oldest first
  std::mutex mutex_;
};

Spares& spares()
{
  static auto& all = *new Spares;  // threads may still compute when statics are gone
  return all;
}

/// Few sizes, so that the factors of a mesh often have the same.
std::size_t roundedSize(std::size_t bytes)
{
  const std::size_t step = std::max(kPage, std::bit_ceil(bytes) / 16);
  return std::max(step, (bytes + step - 1) / step * step);
}

/// Arrays do not share lines of the cache.
std::size_t wholeLines(std::size_t count)
{
  constexpr std::size_t kLine = 8;
  return std::max(kLine, (count + kLine - 1) / kLine * kLine);
}

}  // namespace

void keepFreedMemory() noexcept
{
  constexpr int kLargest = 32 << 20;  // that the C library allows
  ::mallopt(M_ARENA_MAX, 1);
  ::mallopt(M_MMAP_THRESHOLD, kLargest);
  ::mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
}

void FreePages::operator()(double* numbers) const noexcept
{
  if (isLeastMemoryWanted())
    std::free(numbers);
  else
    spares().keep(bytes, numbers);
}

LargeArray largeArray(std::size_t count)
{
  const std::size_t bytes = roundedSize(count * sizeof(double));
  double* numbers = spares().take(bytes);
  if (numbers == nullptr) numbers = static_cast<double*>(std::aligned_alloc(kPage, bytes));
  if (numbers == nullptr) throw std::bad_alloc();
  ::madvise(numbers, bytes, MADV_HUGEPAGE);
  return {numbers, {bytes}};
}

ReusedMemory::Array ReusedMemory::take(std::size_t count)
{
  count = wholeLines(count);
  const std::scoped_lock lock(mutex_);
  auto gap = std::ranges::find_if(gaps_, [&](const auto& entry) { return entry.second >= count; });
  if (gap == gaps_.end()) {
    const std::size_t size = std::max(count, wholeLines(regionSize_));
    regions_.push_back(largeArray(size));
    gap = gaps_.emplace(regions_.back().get(), size).first;
  }
  const auto [place, size] = *gap;
  gap = gaps_.erase(gap);
  if (size > count) gaps_.emplace_hint(gap, place + count, size - count);
  return {place, {this, count}};
}

void ReusedMemory::returnGaps()
{
  if (!isLeastMemoryWanted()) return;
  const std::scoped_lock lock(mutex_);
  for (const auto& [place, size] : gaps_) {
    void* begin = place;
    std::size_t bytes = size * sizeof(double);
    if (std::align(kPage, kPage, begin, bytes) != nullptr) ::madvise(begin, bytes / kPage * kPage, MADV_DONTNEED);
  }
}

void ReusedMemory::giveBack(double* numbers, std::size_t count)
{
  const std::scoped_lock lock(mutex_);
  auto next = gaps_.upper_bound(numbers);
  if (next != gaps_.end() && numbers + count == next->first) {
    count += next->second;
    next = gaps_.erase(next);
  }
  if (next != gaps_.begin())
    if (const auto before = std::prev(next); before->first + before->second == numbers) {
      before->second += count;
      return;
    }
  gaps_.emplace_hint(next, numbers, count);
}

}  // namespace holdfast
