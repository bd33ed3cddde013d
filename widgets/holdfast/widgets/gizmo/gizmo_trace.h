#pragma once
/// \file
/// What is shown of a drag while it goes on: the way so far as a quiet line or sector.

#include <vector>

#include <vtkNew.h>

#include <holdfast/widgets/gizmo/gizmo_drag.h>
#include <holdfast/widgets/gizmo/gizmo_layout.h>

class vtkActor;
class vtkPolyData;
class vtkProp;

namespace holdfast {

/// The state of a drag.
struct GizmoTrace {
  GizmoPart part = GizmoPart::None;
  GizmoFrame from;                    ///< where the gizmo stood when the drag began
  Vector3 grabbed = Vector3::Zero();  ///< `GizmoDrag::grabbed`
  GizmoMotion motion;
};

/// The actors of a trace.
class GizmoTraceActors {
 public:
  GizmoTraceActors();
  ~GizmoTraceActors();
  GizmoTraceActors(const GizmoTraceActors&) = delete;
  GizmoTraceActors& operator=(const GizmoTraceActors&) = delete;

  /// `radius`: of the part that is dragged, model units; `pixels`: of the gizmo's outer ring.
  void show(const GizmoTrace& trace, double radius, double pixels);
  void hide();

  [[nodiscard]] std::vector<vtkProp*> props() const;

 private:
  vtkNew<vtkPolyData> lineData_;
  vtkNew<vtkPolyData> sectorData_;
  vtkNew<vtkPolyData> endData_;
  vtkNew<vtkActor> lines_;
  vtkNew<vtkActor> sector_;
  vtkNew<vtkActor> ends_;
};

}  // namespace holdfast
