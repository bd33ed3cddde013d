#pragma once
/// \file
/// Rotations as places on a sphere that can be looked at: where the unit quaternion exp(q) of a logarithm is drawn.
///
/// Unit quaternions fill a sphere in four dimensions. What is prescribed (fixed vertices, q = 0, and a handle or two)
/// spans a flat of three of them, and so does every blend of its logarithms: the picture is the unit sphere in that
/// flat, and nothing is lost. The identity is its north pole; a turn by an angle lies half that angle from the pole, in
/// the direction of its axis: half turns on the equator, one whole turn at the south pole. Arcs from the pole, and all
/// other great arcs, are what they are. A turn by 270 degrees is not one by -90, so nothing is folded at a half turn,
/// as it would be in a ball of vector parts; on a sphere an angle can be read against rings, in a ball it cannot.
/// Beyond a whole turn the place rises above the sphere, a shell for each turn, so that a second turn does not hide the
/// first. Where more is prescribed than one flat holds, the picture is the shadow on the flat that holds most: what
/// leaves it lies below the surface.

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

/// Whether anything is asked to turn.
[[nodiscard]] bool hasRotation(const std::vector<BoundaryRotation>& boundary);

/// The frame that shows most of `boundary`; `before` where that shows about as much, so that a drag does not turn the
/// picture over.
[[nodiscard]] SphereFrame sphereFrame(const std::vector<BoundaryRotation>& boundary, const SphereFrame& before);

/// Where exp(q) is in the picture: z is the pole.
[[nodiscard]] Vector3 spherePlace(const SphereFrame& frame, const Vector3& q);

/// The great arc between two rotations as a polyline; where they are about one axis, or beyond a whole turn, the way
/// that blends of their logs take.
[[nodiscard]] std::vector<Vector3> sphereArc(const SphereFrame& frame, const Vector3& from, const Vector3& to);

}  // namespace holdfast
