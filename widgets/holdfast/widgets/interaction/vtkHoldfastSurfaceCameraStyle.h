#pragma once
/// Rotates, shifts and zooms the camera about the place of a surface that is under the cursor.

#include <memory>

#include <vtkCommand.h>
#include <vtkInteractorStyle.h>
#include <vtkNew.h>
#include <vtkWidgetEventTranslator.h>

#include <holdfast/widgets/interaction/interaction_events.h>
#include <holdfast/widgets/picking/visible_surface.h>

/// Moves the camera about the place under the cursor. The event translator says what a drag does, and a program may
/// change it. `vtkWidgetEvent::Rotate` orbits the place under the cursor. `Translate` shifts that place with the
/// cursor.
///
///     vtkNew<vtkHoldfastSurfaceCameraStyle> style;
///     style->SetSurface(surface);
///     interactor->SetInteractorStyle(style);
///
/// These are the bindings, each with its widget event:
///
///     LeftButtonPressEvent               Rotate
///     RightButtonPressEvent              Rotate
///     RightButtonPressEvent with Shift   Translate
///     MiddleButtonPressEvent             Translate
///
/// The wheel goes nearer to the place, by 1.2 for each notch, to the power of `GetMouseWheelMotionFactor`. A drag
/// begins when the cursor is 4 pixels away from the press, so that widgets above can take clicks.
///
/// These are the events that it invokes, without call data:
///
///     StartInteractionEvent      a drag begins
///     InteractionEvent           the camera was moved, by the wheel as well
///     EndInteractionEvent        a drag ends, by `Cancel` as well
///     ContextMenuRequestEvent    the right button went down and up in one place
///
/// The keys of `vtkInteractorStyle` ("q" ends the program, "w" draws lines) are not bound.
class vtkHoldfastSurfaceCameraStyle : public vtkInteractorStyle {
 public:
  static vtkHoldfastSurfaceCameraStyle* New();
  vtkTypeMacro(vtkHoldfastSurfaceCameraStyle, vtkInteractorStyle)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Sets the surface, about whose place under the cursor the camera moves. With null, the default, and beside the
  /// surface, it moves about a place at the depth of the focal point.
  void SetSurface(std::shared_ptr<const holdfast::VisibleSurface> surface)
  {
    holdfast::assign(*this, this->Surface, std::move(surface));
  }
  [[nodiscard]] const std::shared_ptr<const holdfast::VisibleSurface>& GetSurface() const { return this->Surface; }

  vtkSetClampMacro(PixelRatio, double, 0.1, 100.0);
  vtkGetMacro(PixelRatio, double);

  vtkWidgetEventTranslator* GetEventTranslator() { return this->EventTranslator; }

  /// Ends a drag that is under way. The camera stays as it is.
  void Cancel();

  void OnLeftButtonDown() override { this->ButtonDown(vtkCommand::LeftButtonPressEvent); }
  void OnLeftButtonUp() override { this->ButtonUp(vtkCommand::LeftButtonPressEvent); }
  void OnMiddleButtonDown() override { this->ButtonDown(vtkCommand::MiddleButtonPressEvent); }
  void OnMiddleButtonUp() override { this->ButtonUp(vtkCommand::MiddleButtonPressEvent); }
  void OnRightButtonDown() override { this->ButtonDown(vtkCommand::RightButtonPressEvent); }
  void OnRightButtonUp() override { this->ButtonUp(vtkCommand::RightButtonPressEvent); }
  void OnMouseMove() override;
  void OnMouseWheelForward() override { this->Zoom(1); }
  void OnMouseWheelBackward() override { this->Zoom(-1); }
  void OnChar() override {}

 protected:
  vtkHoldfastSurfaceCameraStyle();
  ~vtkHoldfastSurfaceCameraStyle() override = default;

 private:
  void ButtonDown(unsigned long event);
  void ButtonUp(unsigned long pressEvent);
  void Zoom(double notches);
  void CameraMoved();
  [[nodiscard]] holdfast::Vector3 PlaceUnder(const holdfast::DisplayPoint& cursor);

  std::shared_ptr<const holdfast::VisibleSurface> Surface;
  double PixelRatio = 1;
  vtkNew<vtkWidgetEventTranslator> EventTranslator;
  unsigned long PressEvent = 0;       // that a button has gone down with; 0 while none is down
  unsigned long Motion = 0;           // the widget event that it means
  holdfast::DisplayPoint Last{0, 0};  // where the cursor was then, or at the last motion of the camera
  holdfast::Vector3 Pivot = holdfast::Vector3::Zero();
};
