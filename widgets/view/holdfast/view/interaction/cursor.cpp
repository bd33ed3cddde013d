#include "holdfast/view/interaction/cursor.h"

#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

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

}  // namespace holdfast
