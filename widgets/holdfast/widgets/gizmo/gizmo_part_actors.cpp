#include "holdfast/widgets/gizmo/gizmo_part_actors.h"

#include <algorithm>
#include <cmath>

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkMatrix4x4.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

namespace holdfast {
namespace {

constexpr int kSolid = 255;

void setUp(vtkActor& actor, vtkPolyData& data, GizmoPart part)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(&data);
  actor.SetMapper(mapper);
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
  // What is drawn last may be blended as it comes. VTK's own way with translucent surfaces takes three times as long
  // as all the rest of the gizmo on a machine without a GPU.
  solid_->ForceOpaqueOn();
  faded_->ForceOpaqueOn();
}

GizmoPartActors::~GizmoPartActors() = default;

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

vtkProp& GizmoPartActors::solid() const
{
  return *solid_;
}

vtkProp& GizmoPartActors::faded() const
{
  return *faded_;
}

Eigen::Matrix<double, 4, 4, Eigen::RowMajor> matrixOf(const GizmoPlacement& placement)
{
  Eigen::Matrix<double, 4, 4, Eigen::RowMajor> matrix = Eigen::Matrix4d::Identity();
  matrix.topLeftCorner<3, 3>() = placement.scale * placement.frame.axes;
  matrix.topRightCorner<3, 1>() = placement.frame.center;
  return matrix;
}

}  // namespace holdfast
