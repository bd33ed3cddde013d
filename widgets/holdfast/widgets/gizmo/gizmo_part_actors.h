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

/// A lit surface of triangles, in radii of the outer ring. It lies about the origin, along the coordinate axes.
struct GizmoShape {
  std::vector<Vector3> points;
  std::vector<Vector3> normals;                 ///< of unit length, one for each point
  std::vector<double> opacities;                ///< one for each point
  std::vector<Vector3> arms;                    ///< of a ring, from the centre to each point's place on it; else empty
  std::vector<std::array<Index, 3>> triangles;  ///< counterclockwise seen from outside
};

/// Returns the shape of a part that is not `None`. The outer ring lies across z.
[[nodiscard]] GizmoShape gizmoShape(GizmoPart part);

/// Draws a part by two actors, one for its solid and one for its translucent triangles. The translucent ones are drawn
/// after the solid ones of all parts.
class GizmoPartActors {
 public:
  explicit GizmoPartActors(GizmoPart part);

  /// Places the part and sets its colour. `visibility` 0 hides it. `sight` is the unit direction in which the gizmo is
  /// seen. O(points).
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

/// A drag as its trace shows it: where it began, and its motion so far.
struct GizmoTrace {
  GizmoPart part = GizmoPart::None;
  GizmoFrame from;                    ///< where the drag began
  Vector3 grabbed = Vector3::Zero();  ///< `GizmoDrag::grabbed`
  GizmoMotion motion;
};

/// Draws the trace of a drag: lines, the ends of a translation, or the sector of a rotation.
class GizmoTraceActors {
 public:
  GizmoTraceActors();

  /// Shows the trace. `radius` is that of the part that is dragged, in model units; `pixels` is the radius of the
  /// gizmo's outer ring.
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
