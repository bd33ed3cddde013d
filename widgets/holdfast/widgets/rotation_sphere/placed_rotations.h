#pragma once
/// The rotations of one deformation as points of the rotation sphere. Nothing of VTK: any thread may place them.

#include <memory>
#include <vector>

#include <holdfast/base/types.h>
#include <holdfast/widgets/rotation_sphere/rotation_projection.h>

namespace holdfast {

/// Which of `places`, all within a few units of the origin, to draw so that they are `most` (positive) or fewer and
/// spread evenly: the first in each cell of a grid that is as fine as that allows, and never finer than `finest`. Lone
/// places stay. Ascending; all where there are no more than `most`. O(N).
[[nodiscard]] std::vector<Index> thinnedPlaces(const std::vector<Vector3>& places, Index most, double finest);

/// The most points that are drawn, spread evenly. A click finds the others too.
inline constexpr Index kMostSpherePoints = 20'000;

/// Which point is whose: one for each unknown of a mesh that a face uses.
struct SphereVertices {
  std::vector<Index> vertexOf;   ///< file vertex of each point
  std::vector<Index> unknownOf;  ///< unknown of each point
  std::vector<Index> pointOf;    ///< of each file vertex; -1 without one
};

/// O(N).
[[nodiscard]] SphereVertices sphereVertices(const Model& model);

/// The points of one deformation on the sphere.
struct PlacedRotations {
  std::shared_ptr<const SphereVertices> vertices;
  std::vector<BoundaryRotation> boundary;  ///< what is prescribed
  SphereFrame frame;
  std::vector<Vector3> places;  ///< of each point, in the picture
  std::vector<Index> drawn;     ///< of the points, ascending: all up to `kMostSpherePoints`
};

/// Places the rotations of `deformation`, which is one of `model`. `before` is what was shown of the same model before,
/// which keeps the picture from turning over; null at first. O(N).
[[nodiscard]] std::shared_ptr<const PlacedRotations> placeRotations(
    const Model& model, const DeformResult& deformation, const std::shared_ptr<const PlacedRotations>& before);

}  // namespace holdfast
