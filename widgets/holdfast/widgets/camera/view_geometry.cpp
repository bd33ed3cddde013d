#include "holdfast/widgets/camera/view_geometry.h"

#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <holdfast/geometry/degree.h>

namespace holdfast {
namespace {

using Matrix34 = Eigen::Matrix<double, 3, 4>;

/// From a cube of [-1, 1] across the viewport to pixels.
Eigen::Matrix3d displayFromCube(vtkRenderer& renderer)
{
  int width = 0;
  int height = 0;
  int left = 0;
  int bottom = 0;
  renderer.GetTiledSizeAndOrigin(&width, &height, &left, &bottom);
  Eigen::Matrix3d result;
  result << width / 2.0, 0, left + width / 2.0, 0, height / 2.0, bottom + height / 2.0, 0, 0, 1;
  return result;
}

/// Without the row of depths.
Matrix34 cubeFromWorld(vtkRenderer& renderer)
{
  const Eigen::Matrix4d cube = projectionOf(renderer) * viewOf(renderer);
  Matrix34 result;
  result << cube.topRows<2>(), cube.row(3);
  return result;
}

/// The part of a row of the projection that is across the view.
Vector3 across(const ViewGeometry& view, int row)
{
  const Vector3 scaled = view.displayFromWorld.row(row).head<3>().transpose();
  return scaled - scaled.dot(view.direction) * view.direction;
}

double weightOf(const ViewGeometry& view, const Vector3& place)
{
  return view.displayFromWorld.row(2).dot(place.homogeneous());
}

// Nearer to the center on the display a place has no direction from it, pixels.
constexpr double kNoDirection = 1;

}  // namespace

ViewGeometry viewGeometryOf(vtkRenderer& renderer)
{
  vtkCamera& camera = *renderer.GetActiveCamera();
  ViewGeometry view;
  view.displayFromWorld = displayFromCube(renderer) * cubeFromWorld(renderer);
  view.eye = Vector3(camera.GetPosition());
  view.direction = Vector3(camera.GetDirectionOfProjection()).normalized();
  view.isParallel = camera.GetParallelProjection() != 0;
  view.up = across(view, 1).normalized();
  view.right = view.direction.cross(view.up);
  return view;
}

ViewRay rayThrough(const ViewGeometry& view, const DisplayPoint& point)
{
  const Matrix34& m = view.displayFromWorld;
  if (!view.isParallel) return {view.eye, m.leftCols<3>().partialPivLu().solve(point.homogeneous()).normalized()};
  const DisplayPoint atEye = (m * view.eye.homogeneous()).head<2>();
  const DisplayPoint shift = point - atEye;
  return {view.eye + shift.x() / across(view, 0).norm() * view.right + shift.y() / across(view, 1).norm() * view.up,
          view.direction};
}

std::optional<DisplayPoint> toDisplay(const ViewGeometry& view, const Vector3& place)
{
  const Vector3 image = view.displayFromWorld * place.homogeneous();
  if (!(image.z() > 0)) return std::nullopt;
  return DisplayPoint(image.hnormalized());
}

double worldPerPixel(const ViewGeometry& view, const Vector3& place)
{
  const double weight = weightOf(view, place);
  return weight > 0 ? weight / across(view, 1).norm() : 0;
}

Vector3 sightOf(const ViewGeometry& view, const Vector3& place)
{
  return view.isParallel ? view.direction : Vector3((place - view.eye).normalized());
}

double degreesSeen(const ViewGeometry& view, const Vector3& center, const Vector3& from, const Vector3& to, double near)
{
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
