#include "holdfast/document/history.h"

namespace holdfast {

History::History(DocumentState state)
{
  states_.push_back({"", std::make_shared<const DocumentState>(std::move(state))});
  saved_ = states_.front().state;
}

void History::push(std::string name, std::shared_ptr<const DocumentState> state)
{
  states_.resize(position_ + 1);
  states_.push_back({std::move(name), std::move(state)});
  if (states_.size() > kLongestHistory + 1) states_.erase(states_.begin());
  position_ = states_.size() - 1;
}

void History::edit(std::string name, DocumentState after)
{
  endGesture();
  push(std::move(name), std::make_shared<const DocumentState>(std::move(after)));
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
  if (gesture && gesture->after != states_[position_].state) push(std::move(gesture->name), gesture->after);
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
