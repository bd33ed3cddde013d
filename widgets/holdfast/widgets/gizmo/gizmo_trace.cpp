#include "holdfast/widgets/gizmo/gizmo_trace.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <holdfast/widgets/gizmo/gizmo_colors.h>
#include <holdfast/widgets/marks/point_sprites.h>

namespace holdfast {
namespace {

constexpr double kStepDegrees = 3;
constexpr double kSectorOpacity = 0.20;

// Of the radius of the outer ring.
constexpr double kLineWidth = 0.018;
constexpr double kEndSize = 0.075;

/// Points of a picture that is made anew for each step of a drag.
struct Sketch {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;

  Sketch() { points->SetDataTypeToDouble(); }
  vtkIdType add(const Vector3& place) { return points->InsertNextPoint(place.data()); }
  void addCell(const std::vector<vtkIdType>& corners)
  {
    cells->InsertNextCell(static_cast<vtkIdType>(corners.size()), corners.data());
  }
};

void showAs(const Sketch& sketch, vtkPolyData& data, void (vtkPolyData::*setCells)(vtkCellArray*))
{
  data.Initialize();
  data.SetPoints(sketch.points);
  (data.*setCells)(sketch.cells);
}

/// Directions from the center, from where the ring was grabbed to where that is now; one turn at most.
std::vector<Vector3> armsOf(const GizmoTrace& trace)
{
  const double degrees = std::clamp(trace.motion.degrees, -360.0, 360.0);
  const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(degrees) / kStepDegrees)));
  std::vector<Vector3> arms;
  for (int k = 0; k <= steps; ++k)
    arms.emplace_back(Eigen::AngleAxisd(degrees / 180 * std::numbers::pi * k / steps, trace.motion.axis) *
                      trace.grabbed);
  return arms;
}

/// Both ends of the way: where it began, and where it is now, also after more than a turn.
void sketchTurn(const GizmoTrace& trace, double radius, Sketch& lines, Sketch& sector)
{
  const Vector3& center = trace.from.center;
  const std::vector<Vector3> arms = armsOf(trace);
  std::vector<vtkIdType> fan{sector.add(center)};
  std::vector<vtkIdType> arc;
  for (const Vector3& arm : arms) {
    fan.push_back(sector.add(center + radius * arm));
    arc.push_back(lines.add(center + radius * arm));
  }
  for (std::size_t k = 1; k + 1 < fan.size(); ++k) sector.addCell({fan[0], fan[k], fan[k + 1]});
  lines.addCell(arc);
  const vtkIdType middle = lines.add(center);
  const Vector3 now =
      Eigen::AngleAxisd(trace.motion.degrees / 180 * std::numbers::pi, trace.motion.axis) * trace.grabbed;
  lines.addCell({middle, arc.front()});
  lines.addCell({middle, lines.add(center + radius * now)});
}

void setUp(vtkActor& actor, vtkPolyData& data)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(&data);
  mapper->ScalarVisibilityOff();
  actor.SetMapper(mapper);
  vtkProperty& property = *actor.GetProperty();
  property.SetColor(kHighlightColor.red, kHighlightColor.green, kHighlightColor.blue);
  property.LightingOff();
  actor.VisibilityOff();
}

}  // namespace

GizmoTraceActors::GizmoTraceActors()
{
  setUp(*lines_, *lineData_);
  setUp(*sector_, *sectorData_);
  setUp(*ends_, *endData_);
  sector_->GetProperty()->SetOpacity(kSectorOpacity);
  sector_->ForceOpaqueOn();  // as with parts that are faded
  drawPointsAsBalls(*ends_);
}

GizmoTraceActors::~GizmoTraceActors() = default;

void GizmoTraceActors::show(const GizmoTrace& trace, double radius, double pixels)
{
  Sketch lines;
  Sketch sector;
  Sketch ends;
  if (isRotation(trace.part)) {
    sketchTurn(trace, radius, lines, sector);
  } else {
    const Vector3 now = trace.from.center + trace.motion.translation;
    ends.addCell({ends.add(trace.from.center)});
    ends.addCell({ends.add(now)});
    lines.addCell({lines.add(trace.from.center), lines.add(now)});
  }
  showAs(lines, *lineData_, &vtkPolyData::SetLines);
  showAs(sector, *sectorData_, &vtkPolyData::SetPolys);
  showAs(ends, *endData_, &vtkPolyData::SetVerts);
  lines_->GetProperty()->SetLineWidth(static_cast<float>(kLineWidth * pixels));
  ends_->GetProperty()->SetPointSize(static_cast<float>(kEndSize * pixels));
  lines_->VisibilityOn();
  sector_->SetVisibility(isRotation(trace.part));
  ends_->SetVisibility(!isRotation(trace.part));
}

void GizmoTraceActors::hide()
{
  for (vtkProp* prop : props()) prop->VisibilityOff();
}

std::vector<vtkProp*> GizmoTraceActors::props() const
{
  return {lines_, ends_, sector_};
}

}  // namespace holdfast
