#pragma once
/// \file
/// VTK's axes in a corner of the window, which show the camera's orientation and change it.

#include <utility>

#include <vtkCameraOrientationRepresentation.h>
#include <vtkCameraOrientationWidget.h>

namespace holdfast {

/// As VTK's, but a click on a ball looks from behind only where that ball faces the viewer (VTK: at every second click
/// on the same ball), and balls and letters are moved, not made for each picture, which would wait for the drawing.
class OrientationRepresentation : public vtkCameraOrientationRepresentation {
 public:
  static OrientationRepresentation* New();
  vtkTypeMacro(OrientationRepresentation, vtkCameraOrientationRepresentation)

  void EndWidgetInteraction(double place[2]) override;

 protected:
  OrientationRepresentation();
  ~OrientationRepresentation() override = default;

  void CreateDefaultGeometry() override {}
  void PositionHandles() override;
  void HighlightHandle() override;

 private:
  [[nodiscard]] bool IsPickedFacing();

  std::pair<int, int> LetteredFor{-2, -2};  // axis and direction of the ball that was picked
};

class OrientationWidget : public vtkCameraOrientationWidget {
 public:
  static OrientationWidget* New();
  vtkTypeMacro(OrientationWidget, vtkCameraOrientationWidget)

  void CreateDefaultRepresentation() override;
  [[nodiscard]] OrientationRepresentation* GetOrientationRepresentation()
  {
    return static_cast<OrientationRepresentation*>(this->GetRepresentation());
  }

  void SetPixelRatio(double ratio);

 protected:
  OrientationWidget() = default;
  ~OrientationWidget() override = default;
};

}  // namespace holdfast
