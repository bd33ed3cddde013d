#pragma once
/// The gizmo as VTK draws it: the shape and the actors of a part, and the actors of the trace of a drag.

#include <array>
#include <vector>

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <holdfast/widgets/color/color_map.h>
#include <holdfast/widgets/gizmo/gizmo_drag.h>
#include <holdfast/widgets/gizmo/gizmo_layout.h>

namespace holdfast {

/// A lit surface of triangles, in radii of the outer ring, about the origin along the coordinate axes.
struct GizmoShape {
  std::vector<Vector3> points;
  std::vector<Vector3> normals;   ///< of unit length, one a point
  std::vector<double> opacities;  ///< one a point
  std::vector<Vector3> arms;      ///< of rings: from the center to the point's place on the ring; else empty
  std::vector<std::array<Index, 3>> triangles;  ///< counterclockwise seen from outside
};

/// The shape of a part that is not `None`. The outer ring lies across z.
[[nodiscard]] GizmoShape gizmoShape(GizmoPart part);

/// Solid and translucent triangles are two actors: the translucent ones are drawn after the solid ones of all parts.
class GizmoPartActors {
 public:
  explicit GizmoPartActors(GizmoPart part);

  /// `visibility` 0 hides it. `sight`: the unit direction in which the gizmo is seen. O(points).
  void show(const GizmoPlacement& placement, const Color& color, double visibility, const Vector3& sight);

  [[nodiscard]] GizmoPart part() const noexcept { return part_; }
  [[nodiscard]] vtkProp& solid() const { return *solid_; }
  [[nodiscard]] vtkProp& faded() const { return *faded_; }

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

struct GizmoTrace {
  GizmoPart part = GizmoPart::None;
  GizmoFrame from;                    ///< where the drag began
  Vector3 grabbed = Vector3::Zero();  ///< `GizmoDrag::grabbed`
  GizmoMotion motion;
};

class GizmoTraceActors {
 public:
  GizmoTraceActors();

  /// `radius`: of the part that is dragged, model units; `pixels`: of the gizmo's outer ring.
  void show(const GizmoTrace& trace, double radius, double pixels);
  void hide();

  [[nodiscard]] std::vector<vtkProp*> props() const { return {lines_, ends_, sector_}; }

 private:
  vtkNew<vtkPolyData> lineData_;
  vtkNew<vtkPolyData> sectorData_;
  vtkNew<vtkPolyData> endData_;
  vtkNew<vtkActor> lines_;
  vtkNew<vtkActor> sector_;
  vtkNew<vtkActor> ends_;
};

}  // namespace holdfast
