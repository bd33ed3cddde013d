#pragma once
/// \file
/// Where an interactor has its cursor.

#include <holdfast/widgets/camera/display_transform.h>

class vtkRenderWindowInteractor;
class vtkRenderer;
class vtkWidgetRepresentation;

namespace holdfast {

/// The pixel of the event that is being handled.
[[nodiscard]] DisplayPoint cursorOf(vtkRenderWindowInteractor& interactor);

/// Whether that pixel is in the renderer's part of the window.
[[nodiscard]] bool isCursorIn(vtkRenderer& renderer, vtkRenderWindowInteractor& interactor);

/// What the representation says of that pixel, and is in from then on: its `ComputeInteractionState`.
int stateAtCursor(vtkWidgetRepresentation& representation, vtkRenderWindowInteractor& interactor);

}  // namespace holdfast
