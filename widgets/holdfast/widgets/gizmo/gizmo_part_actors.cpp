#include "holdfast/widgets/gizmo/gizmo_part_actors.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkMatrix4x4.h>
#include <vtkPointData.h>

#include <holdfast/widgets/marks/point_sprites.h>
#include <holdfast/widgets/mesh/actor_setup.h>

namespace holdfast {
namespace {

constexpr int kSolid = 255;

void setUp(vtkActor& actor, vtkPolyData& data, GizmoPart part)
{
  showData(actor, data);
  vtkProperty& property = *actor.GetProperty();
  property.SetInterpolationToPhong();
  property.SetAmbient(0.58);
  property.SetDiffuse(0.46);
  property.SetSpecular(0.25);
  property.SetSpecularPower(28);
  // The far side of a tube must not shine through the near one; a sheet has two sides.
  property.SetBackfaceCulling(kindOf(part) != GizmoPartKind::Square);
  actor.VisibilityOff();
}

unsigned char byteOf(double share)
{
  return static_cast<unsigned char>(std::lround(255 * std::clamp(share, 0.0, 1.0)));
}

constexpr double kStepDegrees = 3;
constexpr double kSectorOpacity = 0.20;

// A share of the radius of the outer ring.
constexpr double kLineWidth = 0.018;
constexpr double kEndSize = 0.075;

/// Points of a picture that is made for each step of a drag.
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

/// Directions from the center, from the grabbed place of the ring to its place now; one turn at most.
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

/// Both ends of the arc: the grabbed place, and its place now, also after more than a turn.
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
  showData(actor, data);
  setColor(actor, kHighlightColor);
  actor.GetProperty()->LightingOff();
  actor.VisibilityOff();
}

}  // namespace

GizmoPartActors::GizmoPartActors(GizmoPart part) : part_(part), shape_(gizmoShape(part))
{
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  for (std::size_t k = 0; k < shape_.points.size(); ++k) {
    points_->InsertNextPoint(shape_.points[k].data());
    normals->InsertNextTuple(shape_.normals[k].data());
  }
  colors_->SetNumberOfComponents(4);
  colors_->SetNumberOfTuples(static_cast<vtkIdType>(shape_.points.size()));
  for (vtkPolyData* data : {solidData_.Get(), fadedData_.Get()}) {
    data->SetPoints(points_);
    data->GetPointData()->SetNormals(normals);
    data->GetPointData()->SetScalars(colors_);
  }
  setUp(*solid_, *solidData_, part);
  setUp(*faded_, *fadedData_, part);
  // Actors that are drawn last may be blended directly. VTK's own translucent pass takes three times as long as the
  // rest of the gizmo on a machine without a GPU.
  solid_->ForceOpaqueOn();
  faded_->ForceOpaqueOn();
}

void GizmoPartActors::show(const GizmoPlacement& placement, const Color& color, double visibility, const Vector3& sight)
{
  if (!(visibility > 0) || !(placement.scale > 0)) return hide();
  const Vector3 localSight = placement.frame.axes.transpose() * sight;
  for (std::size_t k = 0; k < shape_.points.size(); ++k) {
    const double ofRing = kindOf(part_) == GizmoPartKind::Ring ? ringVisibility(shape_.arms[k], localSight) : 1;
    const unsigned char bytes[] = {byteOf(color.red), byteOf(color.green), byteOf(color.blue),
                                   byteOf(visibility * ofRing * shape_.opacities[k])};
    colors_->SetTypedTuple(static_cast<vtkIdType>(k), bytes);
  }
  vtkNew<vtkCellArray> solid;
  vtkNew<vtkCellArray> faded;
  for (const auto& [a, b, c] : shape_.triangles) {
    const int least = std::min(
        {colors_->GetTypedComponent(a, 3), colors_->GetTypedComponent(b, 3), colors_->GetTypedComponent(c, 3)});
    (least == kSolid ? solid : faded)->InsertNextCell({a, b, c});
  }
  colors_->Modified();
  solidData_->SetPolys(solid);
  fadedData_->SetPolys(faded);
  vtkNew<vtkMatrix4x4> matrix;
  matrix->DeepCopy(matrixOf(placement).data());
  for (vtkActor* actor : {solid_.Get(), faded_.Get()}) actor->SetUserMatrix(matrix);
  solid_->SetVisibility(solid->GetNumberOfCells() > 0);
  faded_->SetVisibility(faded->GetNumberOfCells() > 0);
}

void GizmoPartActors::hide()
{
  solid_->VisibilityOff();
  faded_->VisibilityOff();
}

Eigen::Matrix<double, 4, 4, Eigen::RowMajor> matrixOf(const GizmoPlacement& placement)
{
  Eigen::Matrix<double, 4, 4, Eigen::RowMajor> matrix = Eigen::Matrix4d::Identity();
  matrix.topLeftCorner<3, 3>() = placement.scale * placement.frame.axes;
  matrix.topRightCorner<3, 1>() = placement.frame.center;
  return matrix;
}

GizmoTraceActors::GizmoTraceActors()
{
  setUp(*lines_, *lineData_);
  setUp(*sector_, *sectorData_);
  setUp(*ends_, *endData_);
  sector_->GetProperty()->SetOpacity(kSectorOpacity);
  sector_->ForceOpaqueOn();  // as with parts that are faded
  drawPointsAsBalls(*ends_);
}

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
  setLineWidth(*lines_, kLineWidth * pixels);
  setPointSize(*ends_, kEndSize * pixels);
  lines_->VisibilityOn();
  sector_->SetVisibility(isRotation(trace.part));
  ends_->SetVisibility(!isRotation(trace.part));
}

void GizmoTraceActors::hide()
{
  for (vtkProp* prop : props()) prop->VisibilityOff();
}

}  // namespace holdfast
