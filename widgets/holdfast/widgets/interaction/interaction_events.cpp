#include "holdfast/widgets/interaction/interaction_events.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

#include <vtkInteractorStyle.h>
#include <vtkWidgetRepresentation.h>

namespace holdfast {

bool isCameraMoving(vtkRenderWindowInteractor& interactor)
{
  auto* style = vtkInteractorStyle::SafeDownCast(interactor.GetInteractorStyle());
  return style != nullptr && style->GetState() != VTKIS_NONE;
}

DisplayPoint cursorOf(vtkRenderWindowInteractor& interactor)
{
  const int* position = interactor.GetEventPosition();
  return {position[0], position[1]};
}

int stateAtCursor(vtkWidgetRepresentation& representation, vtkRenderWindowInteractor& interactor)
{
  const int* position = interactor.GetEventPosition();
  return representation.ComputeInteractionState(position[0], position[1]);
}

std::vector<DisplayPoint> circle(const DisplayPoint& center, double radius, int corners)
{
  std::vector<DisplayPoint> points;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * std::numbers::pi * k / corners;
    points.push_back(center + radius * DisplayPoint(std::cos(angle), std::sin(angle)));
  }
  return points;
}

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

SelectionMode selectionModeOf(vtkRenderWindowInteractor& interactor)
{
  if (interactor.GetControlKey() != 0) return SelectionMode::Remove;
  return interactor.GetShiftKey() != 0 ? SelectionMode::Add : SelectionMode::Replace;
}

std::vector<Index> joined(const std::vector<Index>& selected, const std::vector<Index>& reached, SelectionMode mode)
{
  std::vector<Index> result;
  switch (mode) {
    case SelectionMode::Replace:
      return reached;
    case SelectionMode::Add:
      std::set_union(selected.begin(), selected.end(), reached.begin(), reached.end(), std::back_inserter(result));
      break;
    case SelectionMode::Remove:
      std::set_difference(selected.begin(), selected.end(), reached.begin(), reached.end(), std::back_inserter(result));
      break;
  }
  return result;
}

}  // namespace holdfast
