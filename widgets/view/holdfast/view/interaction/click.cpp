#include "holdfast/view/interaction/click.h"

#include <utility>

#include <holdfast/view/interaction/interaction_events.h>

namespace holdfast {

bool Click::leaveAt(const DisplayPoint& place, double pixelRatio)
{
  if (!press_ || (place - *press_).norm() < kClickPixels * pixelRatio) return false;
  press_.reset();
  return true;
}

bool Click::release(const DisplayPoint& place, double pixelRatio)
{
  leaveAt(place, pixelRatio);
  return std::exchange(press_, std::nullopt).has_value();
}

}  // namespace holdfast
