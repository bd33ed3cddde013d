#pragma once
/// \file
/// Where an interactor has its cursor.

#include <holdfast/view/display_transform.h>

class vtkRenderWindowInteractor;
class vtkRenderer;

namespace holdfast {

/// The pixel of the event that is being handled.
[[nodiscard]] DisplayPoint cursorOf(vtkRenderWindowInteractor& interactor);

/// Whether that pixel is in the renderer's part of the window.
[[nodiscard]] bool isCursorIn(vtkRenderer& renderer, vtkRenderWindowInteractor& interactor);

}  // namespace holdfast
