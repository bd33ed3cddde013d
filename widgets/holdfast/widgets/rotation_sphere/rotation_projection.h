#pragma once
/// Rotations as places on a sphere that can be looked at: where the unit quaternion exp(q) of a log q is drawn.
///
/// Unit quaternions are a sphere in four dimensions. Fixed vertices prescribe q = 0, and a handle prescribes a rotation
/// of its own. With a handle or two these rotations and all blends of their logs are in a subspace of three dimensions.
/// The picture is the unit sphere in it.
///
/// The identity is the north pole. A rotation is half its angle away from the pole, in the direction of its axis. Half
/// turns are on the equator, and one whole turn is the south pole. A rotation by 270 degrees is not one by -90. Beyond
/// a whole turn places are above the sphere, one shell for each turn.
///
/// Where the prescribed rotations need more dimensions, the picture is the projection onto the subspace that holds most
/// of them. Other places are then below the surface.

#include <memory>
#include <string>
#include <vector>

#include <holdfast/deform/deform.h>

namespace holdfast {

/// The directions of axes in the picture.
struct SphereFrame {
  /// The columns are orthonormal. They are the axes that lie towards x and y of the picture, and the one that is not
  /// shown.
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
};

/// A rotation that is prescribed, by one constraint or many.
struct BoundaryRotation {
  Vector3 q = Vector3::Zero();  ///< log, radians
  std::string label;            ///< names of the constraints whose first rotation it is; may be empty
};

/// How far above the sphere each whole turn beyond the first lies, in radii.
inline constexpr double kTurnRise = 0.12;

/// Returns the different rotations that the constraints of `deformation` prescribe, in the user's order. O(n log n).
[[nodiscard]] std::vector<BoundaryRotation> boundaryRotations(const DeformResult& deformation);

/// Tells whether any prescribed rotation is not zero.
[[nodiscard]] bool hasRotation(const std::vector<BoundaryRotation>& boundary);

/// Returns the frame that shows most of `boundary`, or `before` where that shows about as much.
[[nodiscard]] SphereFrame sphereFrame(const std::vector<BoundaryRotation>& boundary, const SphereFrame& before);

/// Returns where exp(q) is in the picture. The pole is along z.
[[nodiscard]] Vector3 spherePlace(const SphereFrame& frame, const Vector3& q);

/// Returns the great arc between two rotations. Where they are about one axis, or beyond a whole turn, it is the way of
/// the blends of their logs.
[[nodiscard]] std::vector<Vector3> sphereArc(const SphereFrame& frame, const Vector3& from, const Vector3& to);

/// Returns the indices of at most `most` (positive) of `places`, ascending. It returns all where there are no more than
/// that. The places are within a few units of the origin. It takes the first place in each cell of a grid. The grid is
/// as fine as `most` allows, and never finer than `finest`. O(N log N).
[[nodiscard]] std::vector<Index> thinnedPlaces(const std::vector<Vector3>& places, Index most, double finest);

/// The most points that are drawn, spread evenly. A click finds the others too.
inline constexpr Index kMostSpherePoints = 20'000;

/// Tells which point belongs to which vertex. There is one point for each unknown of a mesh that a face uses.
struct SphereVertices {
  std::vector<Index> vertexOf;   ///< file vertex of each point
  std::vector<Index> unknownOf;  ///< unknown of each point
  std::vector<Index> pointOf;    ///< point of each file vertex; -1 without one
};

/// Numbers the points of a model. O(N).
[[nodiscard]] SphereVertices sphereVertices(const Model& model);

/// The points of one deformation on the sphere.
struct PlacedRotations {
  std::shared_ptr<const SphereVertices> vertices;
  std::vector<BoundaryRotation> boundary;  ///< what is prescribed
  SphereFrame frame;
  std::vector<Vector3> places;  ///< place of each point in the picture
  std::vector<Index> drawn;     ///< the points that are drawn, ascending: all up to `kMostSpherePoints`
};

/// Places the rotations of a deformation. `before` was shown of the same model before, which keeps the picture from
/// turning over. It is null at first.
[[nodiscard]] std::shared_ptr<const PlacedRotations> placeRotations(
    const Model& model, const DeformResult& deformation, const std::shared_ptr<const PlacedRotations>& before);

}  // namespace holdfast
