#pragma once
/// \file
/// What the widgets of this room share: events beside VTK's, cursor, clicks, modes of selection. docs/widgets.md lists
/// the bindings of each widget, which its event translator can change. Sizes are pixels of a display of ordinary
/// resolution; `PixelRatio`, 1 by default, is the number of pixels of the window for each of them.

#include <optional>
#include <vector>

#include <vtkAbstractWidget.h>
#include <vtkCallbackCommand.h>
#include <vtkObjectFactory.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkWidgetCallbackMapper.h>
#include <vtkWidgetEvent.h>

#include <holdfast/base/types.h>
#include <holdfast/widgets/camera/display_transform.h>

class vtkWidgetRepresentation;

namespace holdfast {

/// Events beside those of `vtkCommand`.
enum InteractionEvents : unsigned long {
  /// Instead of EndInteractionEvent: the gesture was taken back; restore the state before it.
  CancelInteractionEvent = vtkCommand::UserEvent + 18'500,
  /// The right button went down and up in one place. Call data: none; the interactor has the place.
  ContextMenuRequestEvent
};

/// A press and a release nearer than this are a click.
inline constexpr double kClickPixels = 4;

/// Whether the interactor's style moves the camera at the moment: nothing follows the cursor then.
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

/// `ComputeInteractionState` of that pixel.
int stateAtCursor(vtkWidgetRepresentation& representation, vtkRenderWindowInteractor& interactor);

/// A click is a press and a release within `kClickPixels`. Widgets abort neither event, so that a drag from the same
/// place moves the camera.
class Click {
 public:
  void Press(const DisplayPoint& place) { this->PressedAt = place; }

  /// The cursor is at `place`: whether that ends a possible click.
  bool LeaveAt(const DisplayPoint& place, double pixelRatio);

  /// Whether the button that comes up at `place` clicks.
  [[nodiscard]] bool Release(const DisplayPoint& place, double pixelRatio);

  void Forget() { this->PressedAt.reset(); }

 private:
  std::optional<DisplayPoint> PressedAt;  // while the button is down and the cursor near
};

enum class SelectionMode { Replace, Add, Remove };

/// By the keys of the event that is handled: Shift adds, Ctrl removes.
[[nodiscard]] SelectionMode selectionModeOf(vtkRenderWindowInteractor& interactor);

/// Arguments and result are ascending, each id once. O(sum of both).
[[nodiscard]] std::vector<Index> joined(const std::vector<Index>& selected, const std::vector<Index>& reached,
                                        SelectionMode mode);

}  // namespace holdfast
