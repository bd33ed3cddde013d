#pragma once
/// VTK's plane as the window shows it.

#include <vtkImplicitPlaneWidget2.h>
#include <vtkNew.h>

#include <holdfast/widgets/interaction/vtkHoldfastSectionPlaneRepresentation.h>
#include <holdfast/window/viewport/viewport.h>

namespace holdfast {

/// A plane that the left button moves and turns, without an outline of the mesh. The other buttons move the camera. It
/// takes the mouse beside the surface alone, but for its arrow and the ball in its middle.
class PlaneWidget : public QObject {
 public:
  PlaneWidget(Viewport& viewport, QObject* parent);

  /// Draws the plane around the mesh at `positions`, through the place nearest to their middle.
  void place(const Positions& positions, const Vector3& point, const Vector3& normal);
  void setEnabled(bool isEnabled) { widget_->SetEnabled(isEnabled ? 1 : 0); }

  [[nodiscard]] vtkImplicitPlaneWidget2& widget() const { return *widget_; }
  [[nodiscard]] Vector3 point() const { return Vector3(plane_->GetOrigin()); }
  [[nodiscard]] Vector3 normal() const { return Vector3(plane_->GetNormal()); }

 private:
  vtkNew<vtkHoldfastSectionPlaneRepresentation> plane_;
  vtkNew<vtkImplicitPlaneWidget2> widget_;
};

}  // namespace holdfast
