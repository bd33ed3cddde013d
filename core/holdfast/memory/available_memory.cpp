#include "holdfast/memory/available_memory.h"

#include <atomic>
#include <fstream>
#include <limits>

#include <fmt/format.h>
#include <malloc.h>

namespace holdfast {
namespace {

std::atomic<int> leastMemories = 0;

void trim()
{
#ifdef __GLIBC__
  ::malloc_trim(0);
#endif
}

}  // namespace

LeastMemory::LeastMemory() noexcept
{
  ++leastMemories;
}

LeastMemory::~LeastMemory()
{
  --leastMemories;
}

std::uint64_t availableMemory()
{
  std::ifstream file("/proc/meminfo");
  std::uint64_t sum = 0;
  bool isFound = false;
  std::string name;
  std::string unit;
  for (std::uint64_t kibibytes = 0; file >> name >> kibibytes && std::getline(file, unit);) {
    if (name != "MemAvailable:" && name != "SwapFree:") continue;
    isFound = true;
    sum += 1024 * kibibytes;
  }
  return isFound ? sum : std::numeric_limits<std::uint64_t>::max();
}

bool isLeastMemoryWanted() noexcept
{
  return leastMemories > 0;
}

void returnFreeMemory()
{
  if (isLeastMemoryWanted()) trim();
}

void requireMemory(std::uint64_t bytes, std::string_view user)
{
  returnFreeMemory();
  if (bytes <= availableMemory()) return;
  trim();
  const std::uint64_t available = availableMemory();
  if (bytes <= available) return;
  constexpr double kGigabyte = 1e9;
  throw LackOfMemory(
      fmt::format("{} needs {:.1f} GB of memory and {:.1f} GB are free; close other programs, or take a "
                  "coarser mesh",
                  user, static_cast<double>(bytes) / kGigabyte, static_cast<double>(available) / kGigabyte));
}

}  // namespace holdfast
