#pragma once
/// \file
/// What the widgets of this room share: events that VTK has no name for, and how a click is told from a drag.

#include <vtkCommand.h>
#include <vtkWidgetEvent.h>

class vtkRenderWindowInteractor;

namespace holdfast {

/// Events beside those of `vtkCommand`.
enum InteractionEvents : unsigned long {
  /// Instead of EndInteractionEvent: the gesture was taken back, and what it changed is to be as before it.
  CancelInteractionEvent = vtkCommand::UserEvent + 18'500,
  /// The right button went down and up in one place. Call data: none; the interactor has the place.
  ContextMenuRequestEvent
};

/// A hand that moves less than this between press and release clicks; pixels of a display of ordinary resolution.
inline constexpr double kClickPixels = 4;

/// Whether the interactor's style turns, shifts or zooms at the moment: nothing is to follow the cursor then.
[[nodiscard]] bool isCameraMoving(vtkRenderWindowInteractor& interactor);

/// Whether the press that is being handled is the second one of a double click.
[[nodiscard]] bool isSecondPress(vtkRenderWindowInteractor& interactor);

}  // namespace holdfast
