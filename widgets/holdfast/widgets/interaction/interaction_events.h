#pragma once
/// \file
/// What the widgets of this room share: events that VTK has no name for, cursor, clicks, modes of selection.

#include <optional>
#include <vector>

#include <vtkAbstractWidget.h>
#include <vtkCommand.h>
#include <vtkWidgetEvent.h>

#include <holdfast/base/types.h>
#include <holdfast/widgets/camera/display_transform.h>

class vtkRenderWindowInteractor;
class vtkRenderer;
class vtkWidgetRepresentation;

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

template <class Widget>
Widget classOf(void (Widget::*action)());

/// A callback of VTK's that calls a member function of the widget.
template <auto Action>
void call(vtkAbstractWidget* widget)
{
  (static_cast<decltype(classOf(Action))*>(widget)->*Action)();
}

/// The pixel of the event that is being handled.
[[nodiscard]] DisplayPoint cursorOf(vtkRenderWindowInteractor& interactor);

/// Whether that pixel is in the renderer's part of the window.
[[nodiscard]] bool isCursorIn(vtkRenderer& renderer, vtkRenderWindowInteractor& interactor);

/// What the representation says of that pixel, and is in from then on: its `ComputeInteractionState`.
int stateAtCursor(vtkWidgetRepresentation& representation, vtkRenderWindowInteractor& interactor);

/// A button that goes down and comes up in one place, within `kClickPixels`, clicks. What listens to clicks aborts
/// neither, so that a drag from the same place is the camera's.
class Click {
 public:
  void Press(const DisplayPoint& place) { this->PressedAt = place; }

  /// The cursor is at `place`. Whether that ends what could have become a click.
  bool LeaveAt(const DisplayPoint& place, double pixelRatio);

  /// Whether the button that comes up at `place` clicks.
  [[nodiscard]] bool Release(const DisplayPoint& place, double pixelRatio);

  void Forget() { this->PressedAt.reset(); }

 private:
  std::optional<DisplayPoint> PressedAt;  // while the button is down and the cursor near
};

enum class SelectionMode { Replace, Add, Remove };

/// Of the event that is being handled: Shift adds, Ctrl takes away.
[[nodiscard]] SelectionMode selectionModeOf(vtkRenderWindowInteractor& interactor);

/// Both ascending, each id once; so the result. O(sum of both).
[[nodiscard]] std::vector<Index> joined(const std::vector<Index>& selected, const std::vector<Index>& reached,
                                        SelectionMode mode);

}  // namespace holdfast
