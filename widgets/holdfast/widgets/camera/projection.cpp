#include "holdfast/widgets/camera/projection.h"

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

namespace holdfast {
namespace {

Eigen::Matrix4d toEigen(vtkMatrix4x4& matrix)
{
  return Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(matrix.GetData());
}

}  // namespace

Eigen::Matrix4d viewOf(vtkRenderer& renderer)
{
  return toEigen(*renderer.GetActiveCamera()->GetModelViewTransformMatrix());
}

Eigen::Matrix4d projectionOf(vtkRenderer& renderer)
{
  // VTK divides what it has multiplied by the nearer end of the range.
  const vtkNew<vtkCamera> camera;
  camera->DeepCopy(renderer.GetActiveCamera());
  camera->SetClippingRange(1, 2);
  return toEigen(*camera->GetProjectionTransformMatrix(renderer.GetTiledAspectRatio(), -1, 1));
}

}  // namespace holdfast
