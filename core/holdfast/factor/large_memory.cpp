#include "holdfast/factor/large_memory.h"

#include <algorithm>
#include <iterator>
#include <new>

#include <sys/mman.h>

namespace holdfast {
namespace {

/// Arrays do not share lines of the cache.
std::size_t wholeLines(std::size_t count)
{
  constexpr std::size_t kLine = 8;
  return std::max(kLine, (count + kLine - 1) / kLine * kLine);
}

}  // namespace

LargeArray largeArray(std::size_t count)
{
  constexpr std::size_t kPage = std::size_t{2} << 20U;
  const std::size_t bytes = std::max(kPage, (count * sizeof(double) + kPage - 1) / kPage * kPage);
  void* const numbers = std::aligned_alloc(kPage, bytes);
  if (numbers == nullptr) throw std::bad_alloc();
  ::madvise(numbers, bytes, MADV_HUGEPAGE);
  return LargeArray(static_cast<double*>(numbers));
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
