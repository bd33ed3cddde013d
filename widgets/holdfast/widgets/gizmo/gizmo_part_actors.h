#pragma once
/// The gizmo as VTK draws it: the actors of a part, and of the trace of a drag.

#include <vector>

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <holdfast/widgets/color/color_map.h>
#include <holdfast/widgets/gizmo/gizmo_drag.h>
#include <holdfast/widgets/gizmo/gizmo_layout.h>
#include <holdfast/widgets/gizmo/gizmo_shapes.h>

namespace holdfast {

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

/// The state of a drag.
struct GizmoTrace {
  GizmoPart part = GizmoPart::None;
  GizmoFrame from;                    ///< where the drag began
  Vector3 grabbed = Vector3::Zero();  ///< `GizmoDrag::grabbed`
  GizmoMotion motion;
};

/// The actors of a trace.
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
