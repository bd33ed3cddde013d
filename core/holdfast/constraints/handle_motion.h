#pragma once
/// Where a handle goes and how it turns: both ways of section 3.3 of the paper to give it its rotation, and more.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include <holdfast/base/error.h>
#include <holdfast/constraints/constraint.h>

namespace holdfast {

/// What cannot be in a handle: the key at fault below that of the constraint (".frame.to.y"), why, and what to do.
struct HandleError {
  std::string key;
  std::string reason;
};

/// The first thing in the handle that contradicts what its type demands: entries for each vertex of what is no list of
/// distinct vertices, or not as many; too few targets; frames of zero or parallel axes; whole turns about no axis.
[[nodiscard]] std::optional<HandleError> validateHandle(const HandleConstraint& handle);

/// The mean of the rows of `points`, one at least.
[[nodiscard]] Vector3 centroid(const Positions& points);

/// The places in `vertices` where an unknown is named first, ascending; `unknownOf` is `Weld::unknownOf`.
[[nodiscard]] std::vector<Index> firstOfUnknowns(std::span<const Index> vertices, const std::vector<int>& unknownOf);

struct HandleSurroundings {
  std::optional<Vector3> fixedCenter;  ///< centroid of all unknowns that are fixed, at rest; none where there are none
  double diagonal = 0;                 ///< of the bounding box of the mesh, model units
};

/// What the motion of a handle depends on besides the handle.
struct HandleSetting {
  Positions rest;  ///< of its vertices, at least one: in the order of its targets and rotations, where it has any
  HandleSurroundings surroundings;
  InputLocation where;               ///< the handle's, for errors
  std::vector<Index> vertices = {};  ///< of the file, in the order of `rest`; may be empty
  /// The rows of `rest` that count in means: one for each unknown, so that copies of a corner change nothing. Empty:
  /// all.
  std::vector<Index> counted = {};

  /// The rows of `ofVertices`, one for each vertex, that count in means.
  [[nodiscard]] Positions once(const Positions& ofVertices) const;
};

/// The mean of the handle's vertices at rest.
[[nodiscard]] Vector3 centroid(const HandleSetting& setting);

/// One row for each vertex of a handle.
struct HandlePlacement {
  Positions places;          ///< where it goes, model units
  Positions q;               ///< how it turns: log, radians
  bool isDetermined = true;  ///< false where other rotations fit the targets as well
};

/// Nearer to the fixed centroid than this share of the diagonal, rounding would turn a handle by 1e-6 radians or more.
inline constexpr double kNoDirection = 1e-9;

/// The handle has no mistake (`validateHandle`). Throws `InputError` with the key at fault: a turn about fixed vertices
/// that do not exist, or that say no direction, or the opposite one; places beyond the range of doubles. O(vertices).
[[nodiscard]] HandlePlacement placeHandle(const HandleConstraint& handle, const HandleSetting& setting);

/// The axes of a frame as columns, orthonormal, right-handed.
[[nodiscard]] Eigen::Matrix3d axesOf(const Frame& frame);

/// How far the handle's centroid moves, as a share of its distance from the fixed one; 0 without such a distance.
[[nodiscard]] double shareMoved(const HandleConstraint& handle, const HandleSetting& setting);

}  // namespace holdfast
