#pragma once
/// \file
/// The camera before a unit sphere about the origin, in parallel projection.

#include <vector>

#include <holdfast/base/types.h>

class vtkCamera;
class vtkRenderer;

namespace holdfast {

/// The direction in which the camera looks, of length 1.
[[nodiscard]] Vector3 sightOf(vtkCamera& camera);

/// Shows all `places`, at least one, from a little beside their middle; the whole sphere where they reach around it.
void lookAtPlaces(vtkCamera& camera, const std::vector<Vector3>& places);

/// Turns the sphere before the camera, as a hand on its near side that moves to the right and up; radians.
void turnSphere(vtkCamera& camera, double right, double up);

/// Shows what is in the picture `factor` times as large, within bounds.
void zoomSphere(vtkCamera& camera, double factor);

/// From places in the world of a renderer to the window: pixels from its lower left corner, and depth in [-1, 1].
class DisplayPlaces {
 public:
  explicit DisplayPlaces(vtkRenderer& renderer);

  [[nodiscard]] Vector3 operator()(const Vector3& place) const
  {
    const Eigen::Vector4d clip = toClip_ * Eigen::Vector4d(place.x(), place.y(), place.z(), 1);
    const Vector3 device = clip.head<3>() / clip.w();
    return {center_.x() + half_.x() * device.x(), center_.y() + half_.y() * device.y(), device.z()};
  }

 private:
  Eigen::Matrix4d toClip_;
  Eigen::Vector2d half_;
  Eigen::Vector2d center_;
};

}  // namespace holdfast
