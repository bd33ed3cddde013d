#pragma once
/// Draws the camera's orientation as axes in a corner of the window.

#include <utility>

#include <vtkCameraOrientationRepresentation.h>

#include <holdfast/widgets/interaction/interaction_events.h>

/// Differs from VTK's representation in two ways. A click on a ball looks from behind only where that ball faces the
/// viewer. (VTK does so at every second click on the same ball.) Balls and letters are moved, not made for each
/// picture: making them would wait for the drawing.
class vtkHoldfastOrientationRepresentation : public vtkCameraOrientationRepresentation {
 public:
  static vtkHoldfastOrientationRepresentation* New();
  vtkTypeMacro(vtkHoldfastOrientationRepresentation, vtkCameraOrientationRepresentation)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void EndWidgetInteraction(double place[2]) override;

 protected:
  vtkHoldfastOrientationRepresentation();
  ~vtkHoldfastOrientationRepresentation() override = default;

  void CreateDefaultGeometry() override {}
  void PositionHandles() override;
  void HighlightHandle() override;

 private:
  std::pair<int, int> LetteredFor{-2, -2};  // axis and direction of the ball that was picked
};
