#pragma once
/// Rotates and zooms the rotation sphere, and picks its points.

#include <vtkInteractorStyle.h>

#include <holdfast/widgets/camera/display_transform.h>
#include <holdfast/widgets/rotation_sphere/rotation_sphere.h>

/// Rotates and zooms a `RotationSphere`, and reports the point that is clicked.
///
///     vtkNew<vtkHoldfastRotationSphereStyle> style;
///     style->SetSphere(&sphere);
///     style->AddObserver(vtkCommand::PickEvent, &tool, &Tool::mark);  // call data: `Index*`
///     interactor->SetInteractorStyle(style);
///
/// These are the bindings. To change them, override `OnLeftButtonDown` and the like.
///
///     drag with the left button     rotates the sphere with the cursor; it begins 4 pixels from the press
///     click with the left button    picks a point
///     arrow keys                    rotate the sphere
///     wheel                         zooms
///     "plus" or "equal"; "minus"    zoom in; out
///     double click, "Home"          shows all that is prescribed
///
/// These are the events that it invokes:
///
///     StartInteractionEvent         a drag begins
///     InteractionEvent              the camera was moved, by any of these bindings
///     EndInteractionEvent           a drag ends
///     PickEvent                     a click on a point; call data: `Index*`, the vertex of the file
class vtkHoldfastRotationSphereStyle : public vtkInteractorStyle {
 public:
  static vtkHoldfastRotationSphereStyle* New();
  vtkTypeMacro(vtkHoldfastRotationSphereStyle, vtkInteractorStyle)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Sets the sphere, which is in a renderer of the interactor's window. It has to live as long as it is set. With
  /// null, the default, there is none.
  void SetSphere(holdfast::RotationSphere* sphere);

  vtkSetClampMacro(PixelRatio, double, 0.1, 100.0);
  vtkGetMacro(PixelRatio, double);

  void OnLeftButtonDown() override;
  void OnLeftButtonUp() override;
  void OnLeftButtonDoubleClick() override
  {
    if (this->Sphere) this->Fit();
  }
  void OnMouseMove() override;
  void OnMouseWheelForward() override { this->Zoom(1); }
  void OnMouseWheelBackward() override { this->Zoom(-1); }
  void OnKeyPress() override;
  void OnChar() override {}

 protected:
  vtkHoldfastRotationSphereStyle() = default;
  ~vtkHoldfastRotationSphereStyle() override = default;

 private:
  void Turn(const holdfast::DisplayPoint& pixels);
  void Zoom(double notches);
  void Fit();
  void CameraMoved();

  holdfast::RotationSphere* Sphere = nullptr;
  double PixelRatio = 1;
  bool IsPressed = false;
  holdfast::DisplayPoint Last{0, 0};
};
