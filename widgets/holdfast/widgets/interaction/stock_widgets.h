#pragma once
/// VTK's own widgets with small changes: the axes in a corner of the window, which show the camera's orientation and
/// change it; the plane that cuts a surface open.

#include <memory>
#include <utility>

#include <vtkCameraOrientationRepresentation.h>
#include <vtkCameraOrientationWidget.h>
#include <vtkImplicitPlaneRepresentation.h>

#include <holdfast/widgets/interaction/interaction_events.h>
#include <holdfast/widgets/picking/visible_surface.h>

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
  std::pair<int, int> LetteredFor{-2, -2};  // axis and direction of the ball that was picked
};

class OrientationWidget : public WidgetOf<OrientationRepresentation, vtkCameraOrientationWidget> {
 public:
  static OrientationWidget* New();
  vtkTypeMacro(OrientationWidget, vtkCameraOrientationWidget)

  [[nodiscard]] OrientationRepresentation* GetOrientationRepresentation() { return &this->Drawn(); }

  void SetPixelRatio(double ratio);

 protected:
  OrientationWidget() = default;
  ~OrientationWidget() override = default;
};

/// As VTK's, but the plane itself takes the mouse only beside the surface, so that the user can pick behind a cut. Its
/// arrow and the ball in its middle take the mouse everywhere.
class SectionPlaneRepresentation : public vtkImplicitPlaneRepresentation {
 public:
  static SectionPlaneRepresentation* New();
  vtkTypeMacro(SectionPlaneRepresentation, vtkImplicitPlaneRepresentation)

  /// The part that is kept; null (the default): none.
  void SetSurface(std::shared_ptr<const VisibleSurface> surface) { this->Surface = std::move(surface); }

  int ComputeInteractionState(int x, int y, int modify = 0) override;

 protected:
  SectionPlaneRepresentation() = default;
  ~SectionPlaneRepresentation() override = default;

 private:
  std::shared_ptr<const VisibleSurface> Surface;
};

}  // namespace holdfast
