#include "holdfast/widgets/interaction/cursor.h"

#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkWidgetRepresentation.h>

namespace holdfast {

DisplayPoint cursorOf(vtkRenderWindowInteractor& interactor)
{
  const int* position = interactor.GetEventPosition();
  return {position[0], position[1]};
}

bool isCursorIn(vtkRenderer& renderer, vtkRenderWindowInteractor& interactor)
{
  const int* position = interactor.GetEventPosition();
  return renderer.IsInViewport(position[0], position[1]) != 0;
}

int stateAtCursor(vtkWidgetRepresentation& representation, vtkRenderWindowInteractor& interactor)
{
  const int* position = interactor.GetEventPosition();
  return representation.ComputeInteractionState(position[0], position[1]);
}

}  // namespace holdfast
