#include "holdfast/document/history.h"

#include <algorithm>

#include <holdfast/surface/surface_locator.h>
#include <holdfast/words/error.h>

namespace holdfast {
namespace {

bool has(const SurfaceLocator& locator, const SurfaceLocation& location)
{
  try {
    static_cast<void>(locator.locate(location, {}));
    return true;
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace

Measurements onMesh(const Measurements& measurements, const SurfaceLocator& locator)
{
  Measurements found = measurements;
  std::erase_if(found.probes, [&](const SurfaceLocation& probe) { return !has(locator, probe); });
  std::erase_if(found.rulers, [&](const std::array<SurfaceLocation, 2>& ends) {
    return !has(locator, ends[0]) || !has(locator, ends[1]);
  });
  return found;
}

History::History(DocumentState state)
{
  states_.push_back({"", std::make_shared<const DocumentState>(std::move(state))});
  saved_ = states_.front().state;
}

void History::push(std::string name, std::shared_ptr<const DocumentState> state, EditKind kind)
{
  states_.resize(position_ + 1);
  states_.push_back({std::move(name), std::move(state), kind});
  if (states_.size() > kLongestHistory + 1) states_.erase(states_.begin());
  position_ = states_.size() - 1;
}

void History::edit(std::string name, DocumentState after, EditKind kind)
{
  endGesture();
  push(std::move(name), std::make_shared<const DocumentState>(std::move(after)), kind);
}

void History::beginGesture(std::string name)
{
  endGesture();
  gesture_ = std::make_unique<Gesture>(Gesture{std::move(name), states_[position_].state});
}

void History::updateGesture(DocumentState after)
{
  assert(gesture_ != nullptr);
  gesture_->after = std::make_shared<const DocumentState>(std::move(after));
}

void History::endGesture()
{
  const auto gesture = std::move(gesture_);
  if (gesture && gesture->after != states_[position_].state)
    push(std::move(gesture->name), gesture->after, EditKind::OfDocument);
}

bool History::isSaved() const
{
  if (saved_ == state()) return true;
  const auto saved = std::ranges::find(states_, saved_, &Entry::state);
  if (saved == states_.end() || state() != states_[position_].state) return false;
  const auto [first, last] = std::minmax({saved - states_.begin(), static_cast<std::ptrdiff_t>(position_)});
  return std::all_of(states_.begin() + first + 1, states_.begin() + last + 1,
                     [](const Entry& entry) { return entry.kind == EditKind::Aside; });
}

bool History::undo()
{
  endGesture();
  if (!canUndo()) return false;
  --position_;
  return true;
}

bool History::redo()
{
  endGesture();
  if (!canRedo()) return false;
  ++position_;
  return true;
}

}  // namespace holdfast
