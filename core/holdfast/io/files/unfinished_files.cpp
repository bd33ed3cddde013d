#include "holdfast/io/files/unfinished_files.h"

#include <array>
#include <atomic>
#include <climits>
#include <cstring>

#include <unistd.h>

#include <holdfast/io/files/output_file.h>

namespace holdfast {
namespace {

enum class SlotState { kFree, kClaimed, kTracked };

struct Slot {
  std::atomic<SlotState> state{SlotState::kFree};
  std::array<char, PATH_MAX> path{};
};

// A signal handler may neither lock nor allocate: fixed storage, and states that change in one step.
static_assert(std::atomic<SlotState>::is_always_lock_free);
std::array<Slot, kTrackedOutputs> slots;

}  // namespace

int trackUnfinishedFile(const std::string& path) noexcept
{
  if (path.size() >= PATH_MAX) return -1;
  for (int i = 0; i < kTrackedOutputs; ++i) {
    SlotState expected = SlotState::kFree;
    if (!slots[i].state.compare_exchange_strong(expected, SlotState::kClaimed)) continue;
    std::memcpy(slots[i].path.data(), path.c_str(), path.size() + 1);
    slots[i].state = SlotState::kTracked;
    return i;
  }
  return -1;
}

void forgetUnfinishedFile(int slot) noexcept
{
  if (slot >= 0) slots[slot].state = SlotState::kFree;
}

void removeUnfinishedOutputs() noexcept
{
  for (const Slot& slot : slots)
    if (slot.state == SlotState::kTracked) ::unlink(slot.path.data());
}

}  // namespace holdfast
