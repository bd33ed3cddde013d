#pragma once
/// Shows the camera's orientation by axes in a corner of the window, and changes it.

#include <vtkCameraOrientationWidget.h>

#include <holdfast/widgets/interaction/interaction_events.h>
#include <holdfast/widgets/interaction/vtkHoldfastOrientationRepresentation.h>

/// Shows the camera's orientation by axes in a corner of the window. A click on a ball of an axis looks along that
/// axis.
///
///     vtkNew<vtkHoldfastOrientationWidget> axes;
///     axes->SetParentRenderer(renderer);  // it is in a window with an interactor
///     axes->On();
///
/// The bindings are those of `vtkCameraOrientationWidget`, each with its widget event. They are for the cursor on the
/// axes:
///
///     MouseMoveEvent            Move: highlights the ball under the cursor, or rotates the camera
///     LeftButtonPressEvent      Select: takes the ball under the cursor
///     LeftButtonReleaseEvent    EndSelect: looks along the axis of that ball, or ends the rotation
///
/// These are the events that it invokes, without call data:
///
///     StartInteractionEvent     the button went down on the axes
///     InteractionEvent          a drag has rotated the camera
///     EndInteractionEvent       the button came up
class vtkHoldfastOrientationWidget
    : public holdfast::WidgetOf<vtkHoldfastOrientationRepresentation, vtkCameraOrientationWidget> {
 public:
  static vtkHoldfastOrientationWidget* New();
  vtkTypeMacro(vtkHoldfastOrientationWidget, vtkCameraOrientationWidget)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  [[nodiscard]] vtkHoldfastOrientationRepresentation* GetOrientationRepresentation() { return &this->Drawn(); }

  void SetPixelRatio(double ratio);

 protected:
  vtkHoldfastOrientationWidget() = default;
  ~vtkHoldfastOrientationWidget() override = default;
};
