#pragma once
/// \file
/// One part of the gizmo as VTK draws it.

#include <vtkNew.h>

#include <holdfast/widgets/color/color_map.h>
#include <holdfast/widgets/gizmo/gizmo_layout.h>
#include <holdfast/widgets/gizmo/gizmo_shapes.h>

class vtkActor;
class vtkPoints;
class vtkPolyData;
class vtkProp;
class vtkUnsignedCharArray;

namespace holdfast {

/// What is drawn solid and what shines through are two actors, because the second have to be drawn after the first ones
/// of all parts.
class GizmoPartActors {
 public:
  explicit GizmoPartActors(GizmoPart part);
  ~GizmoPartActors();
  GizmoPartActors(const GizmoPartActors&) = delete;
  GizmoPartActors& operator=(const GizmoPartActors&) = delete;

  /// `visibility` 0 hides it. `sight`: the unit direction in which the gizmo is seen. O(points).
  void show(const GizmoPlacement& placement, const Color& color, double visibility, const Vector3& sight);
  void hide();

  [[nodiscard]] GizmoPart part() const noexcept { return part_; }
  [[nodiscard]] vtkProp& solid() const;
  [[nodiscard]] vtkProp& faded() const;

 private:
  GizmoPart part_;
  GizmoShape shape_;
  vtkNew<vtkPoints> points_;
  vtkNew<vtkUnsignedCharArray> colors_;
  vtkNew<vtkPolyData> solidData_;
  vtkNew<vtkPolyData> fadedData_;
  vtkNew<vtkActor> solid_;
  vtkNew<vtkActor> faded_;
};

/// The matrix of actors that stand at `placement`, row by row.
[[nodiscard]] Eigen::Matrix<double, 4, 4, Eigen::RowMajor> matrixOf(const GizmoPlacement& placement);

}  // namespace holdfast
