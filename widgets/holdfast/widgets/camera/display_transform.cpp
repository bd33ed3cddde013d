#include "holdfast/widgets/camera/display_transform.h"

#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>

#include <holdfast/geometry/rotation_log.h>

namespace holdfast {
namespace {

Eigen::Matrix4d toEigen(vtkMatrix4x4& matrix)
{
  return Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(matrix.GetData());
}

Vector3 applied(const Eigen::Matrix4d& matrix, const Vector3& place)
{
  return (matrix * place.homogeneous()).hnormalized();
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

DisplayTransform::DisplayTransform(vtkRenderer& renderer)
{
  int size[2];
  int origin[2];
  renderer.GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  size_ = {size[0], size[1]};
  origin_ = {origin[0], origin[1]};
  toView_ = viewOf(renderer);
  project_ = projectionOf(renderer);
  fromView_ = toView_.inverse();
  unproject_ = project_.inverse();
}

DisplayTransform::Shown DisplayTransform::show(const Vector3& place) const
{
  const Vector3 seen = applied(toView_, place);
  const Eigen::Vector4d clip = project_ * seen.homogeneous();
  const DisplayPoint share = (clip.head<2>() / clip[3]).array() / 2 + 0.5;
  return {origin_ + share.cwiseProduct(size_), -seen[2], clip[3]};
}

Ray DisplayTransform::rayThrough(const DisplayPoint& point) const
{
  const DisplayPoint share = 2 * (point - origin_).cwiseQuotient(size_) - DisplayPoint::Ones();
  const Vector3 near = applied(unproject_, {share[0], share[1], -1});
  const Vector3 far = applied(unproject_, {share[0], share[1], 1});
  // The eye looks along -z. For the perspective the ray's origin is the eye but for rounding, which would be magnified.
  const Vector3 direction = (far - near) / (near[2] - far[2]);
  const Vector3 origin = isParallel() ? Vector3(near + near[2] * direction) : Vector3::Zero();
  return {applied(fromView_, origin), fromView_.topLeftCorner<3, 3>() * direction};
}

Ray DisplayTransform::rayTo(const Vector3& place) const
{
  const Ray ray = rayThrough(show(place).point);
  return {ray.origin, place - ray.origin};
}

RayReach DisplayTransform::reachOf(double pixels) const
{
  const double length = pixels / pixelsOfUnit().minCoeff();
  return isParallel() ? RayReach{length, 0} : RayReach{0, length};
}

bool DisplayTransform::isInside(const DisplayPoint& point) const
{
  const DisplayPoint inside = point - origin_;
  return (inside.array() >= 0).all() && (inside.array() <= size_.array()).all();
}

std::optional<DisplayPoint> toDisplay(const DisplayTransform& view, const Vector3& place)
{
  const DisplayTransform::Shown shown = view.show(place);
  return shown.size > 0 ? std::optional(shown.point) : std::nullopt;
}

double degreesSeen(const DisplayTransform& view, const Vector3& center, const Vector3& from, const Vector3& to,
                   double near)
{
  // Pixels: nearer to the center a place has no direction from it.
  constexpr double kNoDirection = 1;
  const auto middle = toDisplay(view, center);
  const auto first = toDisplay(view, from);
  const auto last = toDisplay(view, to);
  if (!middle || !first || !last) return near;
  const DisplayPoint a = *first - *middle;
  const DisplayPoint b = *last - *middle;
  if (!(a.norm() > kNoDirection && b.norm() > kNoDirection)) return near;
  const double degrees = std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)) / kDegree;
  return degrees + 360 * std::round((near - degrees) / 360);
}

}  // namespace holdfast
