#pragma once
/// \file
/// VTK's axes in a corner of the window, which show how the camera stands and turn it.

#include <utility>

#include <vtkCameraOrientationRepresentation.h>
#include <vtkCameraOrientationWidget.h>

namespace holdfast {

/// As VTK's, but a click on a ball looks from behind only where that ball faces the viewer. VTK looks from behind at
/// every second click on the same ball, wherever one has looked in between. Nor are balls and letters made anew for
/// each picture, which waits for what is being drawn where the processor draws: they are moved, and letters are made
/// where another ball is picked.
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
  [[nodiscard]] OrientationRepresentation* GetOrientationRepresentation();

  /// Pixels of the window for each of a display of ordinary resolution; 1 by default.
  void SetPixelRatio(double ratio);

 protected:
  OrientationWidget();
  ~OrientationWidget() override = default;
};

}  // namespace holdfast
