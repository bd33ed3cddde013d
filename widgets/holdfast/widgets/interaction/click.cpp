#include "holdfast/widgets/interaction/click.h"

#include <utility>

#include <holdfast/widgets/interaction/interaction_events.h>

namespace holdfast {

bool Click::LeaveAt(const DisplayPoint& place, double pixelRatio)
{
  if (!this->PressedAt || (place - *this->PressedAt).norm() < kClickPixels * pixelRatio) return false;
  this->PressedAt.reset();
  return true;
}

bool Click::Release(const DisplayPoint& place, double pixelRatio)
{
  this->LeaveAt(place, pixelRatio);
  return std::exchange(this->PressedAt, std::nullopt).has_value();
}

}  // namespace holdfast
