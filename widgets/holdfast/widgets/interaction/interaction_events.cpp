#include "holdfast/widgets/interaction/interaction_events.h"

#include <vtkInteractorStyle.h>
#include <vtkRenderWindowInteractor.h>

namespace holdfast {

bool isCameraMoving(vtkRenderWindowInteractor& interactor)
{
  auto* style = vtkInteractorStyle::SafeDownCast(interactor.GetInteractorStyle());
  return style != nullptr && style->GetState() != VTKIS_NONE;
}

bool isSecondPress(vtkRenderWindowInteractor& interactor)
{
  return interactor.GetRepeatCount() > 0;
}

}  // namespace holdfast
