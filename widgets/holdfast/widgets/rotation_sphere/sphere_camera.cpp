#include "holdfast/widgets/rotation_sphere/sphere_camera.h"

#include <algorithm>
#include <limits>

#include <Eigen/Geometry>

namespace holdfast {
namespace {

// Towards where the camera is shifted from the middle of what it shows.
const Vector3 kBeside(0.25, -0.4, 0.2);
constexpr double kEyeDistance = 10;

// Half the height of the picture, in radii: at least, beyond which all of the sphere is shown, and then.
constexpr double kLeastView = 0.5;
constexpr double kWholeView = 0.9;
constexpr double kWholeScale = 1.2;
constexpr double kViewMargin = 1.25;
constexpr double kNearestView = 0.005;
constexpr double kFarthestView = 20;

}  // namespace

void lookAtPlaces(vtkCamera& camera, const std::vector<Vector3>& places)
{
  Vector3 middle = Vector3::Zero();
  for (const Vector3& place : places) middle += place / static_cast<double>(places.size());
  const Vector3 back = (middle + kBeside).normalized();
  const Vector3 right = Vector3::UnitZ().cross(back).normalized();
  const Vector3 up = back.cross(right);
  Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector2d high = -low;
  for (const Vector3& place : places) {
    const Eigen::Vector2d seen(place.dot(right), place.dot(up));
    low = low.cwiseMin(seen);
    high = high.cwiseMax(seen);
  }
  const double reach = kViewMargin * (high - low).maxCoeff() / 2;
  const bool isWhole = reach > kWholeView;
  const Eigen::Vector2d center = isWhole ? Eigen::Vector2d(0, 0) : Eigen::Vector2d((low + high) / 2);
  const Vector3 focus = center.x() * right + center.y() * up;
  const Vector3 eye = focus + kEyeDistance * back;
  camera.SetFocalPoint(focus.data());
  camera.SetPosition(eye.data());
  camera.SetViewUp(up.data());
  camera.SetParallelScale(isWhole ? std::max(reach, kWholeScale) : std::max(reach, kLeastView));
}

void zoomSphere(vtkCamera& camera, double factor)
{
  camera.SetParallelScale(std::clamp(camera.GetParallelScale() / factor, kNearestView, kFarthestView));
}

}  // namespace holdfast
