#pragma once
/// Turns, shifts and zooms the camera about the place of a surface that is under the cursor.

#include <memory>

#include <vtkCommand.h>
#include <vtkInteractorStyle.h>
#include <vtkNew.h>
#include <vtkWidgetEventTranslator.h>

#include <holdfast/widgets/interaction/interaction_events.h>
#include <holdfast/widgets/picking/visible_surface.h>

namespace holdfast {

/// The event translator says what a drag does; a program may change it. `vtkWidgetEvent::Rotate` orbits the place under
/// the cursor, `Translate` shifts that place with the cursor. The wheel goes nearer to it, 1.2 times a notch to the
/// power of `GetMouseWheelMotionFactor`. A drag begins when the cursor has left the place of the press by 4 pixels, so
/// that widgets above can take clicks.
///
/// Keys of `vtkInteractorStyle` ("q" ends the program, "w" draws lines) are not bound.
class SurfaceCameraStyle : public vtkInteractorStyle {
 public:
  static SurfaceCameraStyle* New();
  vtkTypeMacro(SurfaceCameraStyle, vtkInteractorStyle)

  /// The motion is about its place under the cursor; null (the default) and beside it: about the depth of the focus.
  void SetSurface(std::shared_ptr<const VisibleSurface> surface) { assign(*this, this->Surface, std::move(surface)); }
  [[nodiscard]] const std::shared_ptr<const VisibleSurface>& GetSurface() const { return this->Surface; }

  vtkSetClampMacro(PixelRatio, double, 0.1, 100.0);
  vtkGetMacro(PixelRatio, double);

  vtkWidgetEventTranslator* GetEventTranslator() { return this->EventTranslator; }

  /// Ends a drag that is under way; the camera stays as it is.
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
  SurfaceCameraStyle();
  ~SurfaceCameraStyle() override = default;

 private:
  void ButtonDown(unsigned long event);
  void ButtonUp(unsigned long pressEvent);
  void Zoom(double notches);
  void CameraMoved();
  [[nodiscard]] Vector3 PlaceUnder(const DisplayPoint& cursor);

  std::shared_ptr<const VisibleSurface> Surface;
  double PixelRatio = 1;
  vtkNew<vtkWidgetEventTranslator> EventTranslator;
  unsigned long PressEvent = 0;  // that a button has gone down with; 0 while none is down
  unsigned long Motion = 0;      // the widget event that it means
  DisplayPoint Last{0, 0};       // where the cursor was then, or at the last motion of the camera
  Vector3 Pivot = Vector3::Zero();
};

}  // namespace holdfast
