#pragma once
/// Axes of what a user moves, instead of those of the world.

#include <holdfast/deform/model.h>
#include <holdfast/surface/surface_point.h>

namespace holdfast {

/// Right-handed orthonormal columns: z along `direction`, x along the axis of the world that is most nearly across it,
/// as far as it is. The identity where the direction is zero.
[[nodiscard]] Eigen::Matrix3d axesAbout(const Vector3& direction);

/// z across the surface, x and y along it: the area-weighted mean of the faces that the point lies in, on an edge or a
/// vertex of. The identity where these have no area. `positions`: one row for each vertex of the file. O(faces).
[[nodiscard]] Eigen::Matrix3d surfaceAxes(const Model& model, const SurfacePoint& point, const Positions& positions);

/// z along the principal axis of `places` whose variance differs most from the other two: the axis of a shaft, the
/// normal of a plate. The identity where the three are alike within a twentieth of the largest. O(places).
[[nodiscard]] Eigen::Matrix3d principalAxes(const Positions& places);

}  // namespace holdfast
