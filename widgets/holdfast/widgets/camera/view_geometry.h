#pragma once
/// \file
/// How a renderer sees the world, as plain numbers: what hit tests and drags compute with.

#include <optional>

#include <holdfast/widgets/camera/display_transform.h>

class vtkRenderer;

namespace holdfast {

/// A view of the world.
struct ViewGeometry {
  /// Takes (x, y, z, 1) to w times (column, row, 1) of the display. w is the distance from the eye's plane in a
  /// perspective, and 1 in a parallel projection. Knows nothing of depth buffers and clipping planes.
  Eigen::Matrix<double, 3, 4> displayFromWorld = Eigen::Matrix<double, 3, 4>::Zero();
  Vector3 eye = Vector3::Zero();
  Vector3 right = Vector3::UnitX();       ///< of unit length, as are the next two
  Vector3 up = Vector3::UnitY();          ///< on the display
  Vector3 direction = -Vector3::UnitZ();  ///< into the picture
  bool isParallel = false;
};

/// The view of a renderer that is in a window with a size.
[[nodiscard]] ViewGeometry viewGeometryOf(vtkRenderer& renderer);

/// A half line that begins at the eye, or, in a parallel projection, on the plane across the view through it.
struct ViewRay {
  Vector3 origin;
  Vector3 direction;  ///< of unit length
};

[[nodiscard]] ViewRay rayThrough(const ViewGeometry& view, const DisplayPoint& point);

/// Where a place appears; none for places that are not in front of the eye.
[[nodiscard]] std::optional<DisplayPoint> toDisplay(const ViewGeometry& view, const Vector3& place);

/// How long a pixel is at `place`, across the view, in model units; 0 for places that are not in front of the eye.
[[nodiscard]] double worldPerPixel(const ViewGeometry& view, const Vector3& place);

/// The unit direction in which `place` is seen.
[[nodiscard]] Vector3 sightOf(const ViewGeometry& view, const Vector3& place);

/// The angle on the display between the directions from `center` to `from` and to `to`, degrees counterclockwise, about
/// the viewing axis towards the eye. It is the angle nearest to `near` among those that differ by whole turns; `near`
/// where one of the three is not in front of the eye, or appears where the center does. Places in model units.
[[nodiscard]] double degreesSeen(const ViewGeometry& view, const Vector3& center, const Vector3& from,
                                 const Vector3& to, double near);

}  // namespace holdfast
