#pragma once
/// Turning bodies turn as one under a set of constraints. The gap of some dependent rows depends on how they turn.

#include <vector>

#include <Eigen/Geometry>

#include <holdfast/elimination/diagnosis.h>

namespace holdfast {

/// A rigid region together with those that overlap it, or a single vector that is kept.
struct TurningBody {
  std::vector<Index> unknowns;  ///< of the region, ascending; none for a vector
  std::vector<Index> rotated;   ///< places in `ConstraintSystem::rotated` of the vectors that turn with it
};

/// `arm` turned by the rotation of `body`.
struct TurnedArm {
  Index body = 0;
  Vector3 arm = Vector3::Zero();  ///< at rest, model units
};

/// A dependent row whose gap depends on rotations. The gap is `asked` less the sum of R_body arm.
struct TurningGap {
  Index row = 0;
  RowTerms circuit;                 ///< rows with coefficients: 1 for `row`, -a_k for those that it follows from
  Vector3 asked = Vector3::Zero();  ///< model units
  std::vector<TurnedArm> arms;      ///< ascending by body; none is 0
  double limit = 0;                 ///< the largest gap that is rounding
};

struct TurningBodies {
  /// The rows of `system` must be those of `eliminated`. O(terms).
  TurningBodies(const EliminatedConstraints& eliminated, const ConstraintSystem& system, const SolverMesh& mesh);

  std::vector<TurningBody> bodies;
  std::vector<Index> bodyOfUnknown;  ///< the region that each unknown is in; -1 where it is in none
  std::vector<TurningGap> gaps;      ///< ascending by row, so in the user's order
};

}  // namespace holdfast
