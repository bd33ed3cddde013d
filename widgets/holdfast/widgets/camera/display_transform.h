#pragma once
/// Transforms between places of the model and places on the screen.

#include <algorithm>
#include <optional>

#include <Eigen/Core>
#include <vtkRenderer.h>

#include <holdfast/surface/ray_caster.h>

namespace holdfast {

/// Returns the transform from places of the model to the axes of the renderer's camera. Its x is to the right, y up,
/// and z towards the eye, which is at 0.
[[nodiscard]] Eigen::Matrix4d viewOf(vtkRenderer& renderer);

/// Returns the transform from these axes to the cube of [-1, 1] across the viewport. Depths in the cube have no
/// meaning, because the camera's clipping range has no part in it. So a click names the same place, to the last bit,
/// whatever else is drawn.
[[nodiscard]] Eigen::Matrix4d projectionOf(vtkRenderer& renderer);

/// A point in pixels from the lower left corner of the window. The centre of the pixel (x, y) is (x + 0.5, y + 0.5).
using DisplayPoint = Eigen::Vector2d;

/// Returns the centre of the pixel that a cursor's coordinates name.
[[nodiscard]] inline DisplayPoint centerOfPixel(double x, double y)
{
  return {x + 0.5, y + 0.5};
}

/// How a renderer's camera, perspective or parallel, shows places at the time of construction. It also shows what the
/// renderer would clip: clipping follows the model only when a picture is drawn.
///
///     const DisplayTransform view(*renderer);
///     const Ray sight = view.rayThrough(centerOfPixel(x, y));
///     const bool isInFront = view.show(place).depth > 0;
class DisplayTransform {
 public:
  DisplayTransform() = default;
  /// Takes the camera of a renderer, which belongs to a window of known size.
  explicit DisplayTransform(vtkRenderer& renderer);

  [[nodiscard]] bool isParallel() const { return project_.row(3).head<3>().isZero(0); }
  [[nodiscard]] Vector3 eye() const { return fromView_.topRightCorner<3, 1>(); }
  // These directions are of unit length.
  [[nodiscard]] Vector3 right() const { return toView_.row(0).head<3>(); }
  [[nodiscard]] Vector3 up() const { return toView_.row(1).head<3>(); }
  /// Returns the direction into the picture.
  [[nodiscard]] Vector3 direction() const { return -toView_.row(2).head<3>(); }

  /// A place as it is shown.
  struct Shown {
    DisplayPoint point = DisplayPoint::Zero();  ///< only where `depth` > 0
    double depth = 0;  ///< distance from the plane through the eye across the direction of view, model units
    double size = 0;   ///< lengths near the place are shown in inverse proportion to this
  };
  [[nodiscard]] Shown show(const Vector3& place) const;

  /// Returns the ray through a point of the screen. It begins at the eye, or for parallel projection in the plane of
  /// the eye.
  [[nodiscard]] Ray rayThrough(const DisplayPoint& point) const;

  /// Returns the ray to a place in front of the eye. It is at the place at t = 1, but for rounding.
  [[nodiscard]] Ray rayTo(const Vector3& place) const;

  /// Returns a reach of the ray through a point of the screen. What is shown no farther than `pixels` from the point is
  /// within this reach.
  [[nodiscard]] RayReach reachOf(double pixels) const;

  /// Tells whether the point lies in the part of the window that the renderer draws to.
  [[nodiscard]] bool isInside(const DisplayPoint& point) const;

  /// Returns how long a pixel is at `place`, across the view, in model units. It is 0 for places that are not in front
  /// of the eye.
  [[nodiscard]] double worldPerPixel(const Vector3& place) const
  {
    return std::max(0.0, show(place).size) / pixelsOfUnit().y();
  }

  /// Returns the unit direction in which `place` is seen.
  [[nodiscard]] Vector3 sightOf(const Vector3& place) const
  {
    return isParallel() ? direction() : Vector3((place - eye()).normalized());
  }

 private:
  /// Returns the pixels of a unit of length that is seen at depth 1 or, for parallel projection, at any depth.
  [[nodiscard]] DisplayPoint pixelsOfUnit() const
  {
    return 0.5 * project_.diagonal().head<2>().cwiseAbs().cwiseProduct(size_);
  }

  DisplayPoint origin_{0, 0};  // lower left corner of the renderer's part of the window
  DisplayPoint size_{1, 1};    // of that part
  Eigen::Matrix4d toView_ = Eigen::Matrix4d::Identity();
  Eigen::Matrix4d fromView_ = Eigen::Matrix4d::Identity();
  Eigen::Matrix4d project_ = Eigen::Matrix4d::Identity();
  Eigen::Matrix4d unproject_ = Eigen::Matrix4d::Identity();
};

/// Returns where a place appears; none for places that are not in front of the eye.
[[nodiscard]] std::optional<DisplayPoint> toDisplay(const DisplayTransform& view, const Vector3& place);

/// Returns the angle on the display from the direction of `from` to that of `to`, seen from `center`. It is in degrees
/// counterclockwise, of all turns the one nearest to `near`. It is `near` where a place is not in front of the eye, or
/// appears where the centre does.
[[nodiscard]] double degreesSeen(const DisplayTransform& view, const Vector3& center, const Vector3& from,
                                 const Vector3& to, double near);

}  // namespace holdfast
