#pragma once
/// A stated motion is what targets say together. They may be the points turned, shifted or scaled as a whole. Two of
/// them may have been swapped. A region may have to stay level where the surface around it tilts.

#include <vector>

#include <holdfast/constraints/constraint_system.h>
#include <holdfast/verdict/result_verdict.h>
#include <holdfast/verdict/shape_change.h>

namespace holdfast {

/// The motion that takes points of one part to their targets as nearly as a rotation, a factor and a shift can.
struct WholeMotion {
  int part = 0;
  TargetMotion motion;
  std::vector<Index> constraints;  ///< places in the list, ascending

  /// Tells whether this motion is what targets say, and what is left is a deformation.
  [[nodiscard]] bool explainsTargets() const;
};

/// A detail is seen to be off when it is off by a tenth of its own size. A rotation of 5.7 degrees and a factor of 1.1
/// do that.
inline constexpr double kVisibleDetail = 0.1;

/// Where more than this share of the distances is left, targets say more than one motion.
inline constexpr double kLargestShareLeft = 0.25;

/// Returns the motion of each part with three points or more that are not on a line. O(rows).
[[nodiscard]] std::vector<WholeMotion> wholeMotions(const ConstraintSystem& system, const SolverMesh& mesh);

/// Returns the places in the list of points whose targets would be met far better by each other, in pairs. It also
/// returns vectors that are the opposite of what they are at rest. O(rows log rows).
[[nodiscard]] std::vector<Index> swappedTargets(const ConstraintSystem& system, const SolverMesh& mesh);

/// A region that goes where the surface moves it and does not turn with it.
struct LevelRegion {
  Index constraint = 0;  ///< place in the list
  double degrees = 0;    ///< between its rotation and that of the surface around it
};

/// Returns rigid regions, and handles that state no rotation, that stay level. The surface around them turns meanwhile,
/// by an angle that is seen. O(rows + vertices times regions).
[[nodiscard]] std::vector<LevelRegion> levelRegions(const DeformedSurface& surface, const ConstraintSystem& system);

}  // namespace holdfast
