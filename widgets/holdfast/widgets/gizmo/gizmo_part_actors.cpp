#include "holdfast/widgets/gizmo/gizmo_part_actors.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkMatrix4x4.h>
#include <vtkPointData.h>

#include <holdfast/geometry/degree.h>
#include <holdfast/widgets/marks/point_sprites.h>
#include <holdfast/widgets/mesh/actor_setup.h>
#include <holdfast/widgets/mesh/poly_data.h>

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

/// From the grabbed place of the ring, one turn at most, to its place now.
void showTurn(const GizmoTrace& trace, double radius, vtkPolyData& lines, vtkPolyData& sector)
{
  const Vector3& center = trace.from.center;
  const auto placeAt = [&](double degrees) -> Vector3 {
    return center + radius * (Eigen::AngleAxisd(degrees * kDegree, trace.motion.axis) * trace.grabbed);
  };
  const double degrees = std::clamp(trace.motion.degrees, -360.0, 360.0);
  const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(degrees) / kStepDegrees)));
  std::vector<Vector3> arc{placeAt(0)};
  std::vector<std::vector<Vector3>> fan;
  for (int k = 1; k <= steps; ++k) {
    arc.push_back(placeAt(degrees * k / steps));
    fan.push_back({center, arc[arc.size() - 2], arc.back()});
  }
  setLines(lines, {arc, {center, arc.front()}, {center, placeAt(trace.motion.degrees)}});
  setPolygons(sector, fan);
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
  solid_->VisibilityOff();
  faded_->VisibilityOff();
  if (!(visibility > 0) || !(placement.scale > 0)) return;
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
  Eigen::Matrix<double, 4, 4, Eigen::RowMajor> place = Eigen::Matrix4d::Identity();
  place.topLeftCorner<3, 3>() = placement.scale * placement.frame.axes;
  place.topRightCorner<3, 1>() = placement.frame.center;
  vtkNew<vtkMatrix4x4> matrix;
  matrix->DeepCopy(place.data());
  for (vtkActor* actor : {solid_.Get(), faded_.Get()}) actor->SetUserMatrix(matrix);
  solid_->SetVisibility(solid->GetNumberOfCells() > 0);
  faded_->SetVisibility(faded->GetNumberOfCells() > 0);
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
  const bool isTurn = isRotation(trace.part);
  if (isTurn) {
    showTurn(trace, radius, *lineData_, *sectorData_);
  } else {
    const std::vector<Vector3> ends{trace.from.center, trace.from.center + trace.motion.translation};
    setLines(*lineData_, {ends});
    setPoints(*endData_, ends);
  }
  setLineWidth(*lines_, kLineWidth * pixels);
  setPointSize(*ends_, kEndSize * pixels);
  lines_->VisibilityOn();
  sector_->SetVisibility(isTurn);
  ends_->SetVisibility(!isTurn);
}

void GizmoTraceActors::hide()
{
  for (vtkProp* prop : props()) prop->VisibilityOff();
}

}  // namespace holdfast
