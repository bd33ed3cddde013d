#pragma once
/// These functions tell where a handle goes and how it turns. They have both ways of section 3.3 of the paper to give
/// it its rotation, and more.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include <holdfast/constraints/constraint.h>
#include <holdfast/words/error.h>

namespace holdfast {

/// An error says what cannot be in a handle. It has the key at fault below that of the constraint (".frame.to.y"), why,
/// and what to do.
struct HandleError {
  std::string key;
  std::string reason;
};

/// Returns the first thing in the handle that contradicts what its type demands. Entries for each vertex need a list of
/// distinct vertices, and as many entries as vertices. Targets must not be too few. Axes of frames must not be zero or
/// parallel. Whole turns need an axis. Factors of the scale must be above 0, and targets have none.
[[nodiscard]] std::optional<HandleError> validateHandle(const HandleConstraint& handle);

/// Returns the mean of the rows of `points`, of which there is at least one.
[[nodiscard]] Vector3 centroid(const Positions& points);

/// Returns the places in `vertices` where an unknown is named first, ascending. `unknownOf` is `Weld::unknownOf`.
[[nodiscard]] std::vector<Index> firstOfUnknowns(std::span<const Index> vertices, const std::vector<int>& unknownOf);

struct HandleSurroundings {
  std::optional<Vector3> fixedCenter;  ///< centroid of all unknowns that are fixed, at rest; none where there are none
  double diagonal = 0;                 ///< of the bounding box of the mesh, model units
};

/// A setting holds what the motion of a handle depends on besides the handle.
struct HandleSetting {
  Positions rest;  ///< of its vertices, at least one: in the order of its targets and rotations, where it has any
  HandleSurroundings surroundings;
  InputLocation where;               ///< the handle's, for errors
  std::vector<Index> vertices = {};  ///< of the file, in the order of `rest`; may be empty
  /// These rows of `rest` count in means. There is one for each unknown, so that copies of a corner change nothing. If
  /// the list is empty, all rows count.
  std::vector<Index> counted = {};

  /// Returns the rows of `ofVertices` that count in means. `ofVertices` has one row for each vertex.
  [[nodiscard]] Positions once(const Positions& ofVertices) const;
};

/// Returns the mean of the handle's vertices at rest.
[[nodiscard]] Vector3 centroid(const HandleSetting& setting);

/// A placement has one row for each vertex of a handle.
struct HandlePlacement {
  Positions places;          ///< where it goes, model units
  Positions q;               ///< how it turns: log, radians
  bool isDetermined = true;  ///< false where other rotations fit the targets as well
};

/// A handle may lie nearer to the fixed centroid than this share of the diagonal. Then rounding would turn it by 1e-6
/// radians or more.
inline constexpr double kNoDirection = 1e-9;

/// Places a handle that has no mistake (`validateHandle`). Throws `InputError` with the key at fault. It refuses a turn
/// about fixed vertices that do not exist, or that say no direction, or the opposite one. It refuses places beyond the
/// range of doubles. O(vertices).
[[nodiscard]] HandlePlacement placeHandle(const HandleConstraint& handle, const HandleSetting& setting);

/// Tells whether a handle keeps its shape: one factor for all axes.
[[nodiscard]] inline bool isUniform(const Vector3& scale)
{
  return scale.x() == scale.y() && scale.y() == scale.z();
}

/// Returns the axes of a frame as columns, orthonormal and right-handed.
[[nodiscard]] Eigen::Matrix3d axesOf(const Frame& frame);

/// Returns how far the handle's centroid moves, as a share of its distance from the fixed one. Returns 0 without such a
/// distance.
[[nodiscard]] double shareMoved(const HandleConstraint& handle, const HandleSetting& setting);

}  // namespace holdfast
