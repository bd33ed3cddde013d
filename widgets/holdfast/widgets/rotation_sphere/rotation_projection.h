#pragma once
/// Rotations as places on a sphere that can be looked at: where the unit quaternion exp(q) of a logarithm is drawn.
///
/// Unit quaternions are a sphere in four dimensions. The prescribed rotations (fixed vertices, q = 0, and a handle or
/// two) and all blends of their logarithms are in a subspace of three dimensions: the picture is the unit sphere in it.
/// The identity is the north pole; a rotation is half its angle away from the pole, in the direction of its axis: half
/// turns are on the equator, one whole turn is the south pole. A rotation by 270 degrees is not one by -90. Beyond a
/// whole turn places are above the sphere, one shell for each turn. Where the prescribed rotations need more
/// dimensions, the picture is the projection onto the subspace that holds most: other places are below the surface.

#include <string>
#include <vector>

#include <holdfast/deform/deform.h>

namespace holdfast {

/// Directions of axes in the picture.
struct SphereFrame {
  /// Columns, orthonormal: the axes that lie towards x and y of the picture, and the one that is not shown.
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
};

/// A rotation that is prescribed, by one constraint or many.
struct BoundaryRotation {
  Vector3 q = Vector3::Zero();  ///< log, radians
  std::string label;            ///< names of the constraints whose first rotation it is; may be empty
};

/// How far above the sphere each whole turn beyond the first lies, in radii.
inline constexpr double kTurnRise = 0.12;

/// The different rotations that the constraints of `deformation` prescribe, in the user's order. O(n log n).
[[nodiscard]] std::vector<BoundaryRotation> boundaryRotations(const DeformResult& deformation);

/// Whether any prescribed rotation is not zero.
[[nodiscard]] bool hasRotation(const std::vector<BoundaryRotation>& boundary);

/// The frame that shows most of `boundary`; `before` where that shows about as much, so that a drag does not flip the
/// picture.
[[nodiscard]] SphereFrame sphereFrame(const std::vector<BoundaryRotation>& boundary, const SphereFrame& before);

/// Where exp(q) is in the picture: z is the pole.
[[nodiscard]] Vector3 spherePlace(const SphereFrame& frame, const Vector3& q);

/// The great arc between two rotations as a polyline; where they are about one axis, or beyond a whole turn, the way
/// that blends of their logs take.
[[nodiscard]] std::vector<Vector3> sphereArc(const SphereFrame& frame, const Vector3& from, const Vector3& to);

}  // namespace holdfast
