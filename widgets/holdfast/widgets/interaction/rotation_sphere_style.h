#pragma once
/// Turns and zooms the rotation sphere, and picks its points.

#include <vtkInteractorStyle.h>

#include <holdfast/widgets/camera/display_transform.h>
#include <holdfast/widgets/rotation_sphere/rotation_sphere.h>

namespace holdfast {

/// A drag with the left button rotates the sphere with the cursor, the wheel and "plus" and "minus" zoom, arrow keys
/// rotate, a double click and "Home" show all that is prescribed.
class RotationSphereStyle : public vtkInteractorStyle {
 public:
  static RotationSphereStyle* New();
  vtkTypeMacro(RotationSphereStyle, vtkInteractorStyle)

  /// In a renderer of the interactor's window, and alive as long as it is set. Null, the default: none.
  void SetSphere(RotationSphere* sphere);

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
  RotationSphereStyle() = default;
  ~RotationSphereStyle() override = default;

 private:
  void Turn(const DisplayPoint& pixels);
  void Zoom(double notches);
  void Fit();
  void CameraMoved();

  RotationSphere* Sphere = nullptr;
  double PixelRatio = 1;
  bool IsPressed = false;
  DisplayPoint Last{0, 0};
};

}  // namespace holdfast
