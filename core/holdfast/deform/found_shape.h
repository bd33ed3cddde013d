#pragma once
/// The shape whose rotations are found with it: local-global iteration under exact constraints.

#include <functional>
#include <map>
#include <vector>

#include <holdfast/check/finding.h>
#include <holdfast/deform/report.h>
#include <holdfast/rotation/rotation_energy.h>
#include <holdfast/solve/axis_solvers.h>
#include <holdfast/threads/progress.h>

namespace holdfast {

/// What shapes are found for.
struct FoundProblem {
  const RotationEnergy& energy;
  const SolverMesh& mesh;
  const AxisSolvers& solvers;  ///< of `energy.A()`
  /// Each iteration calls this where points have tolerances. It gives them the best targets. `displacement` solves for
  /// those that they have, with A u near `f`. It is taken to the new targets where that costs no solution; the call
  /// returns whether it was.
  std::function<bool(ConstraintSystem& system, Displacement& displacement, const Columns3& f)> chooseTargets = {};
};

struct FoundShape {
  Displacement displacement;  ///< of the last iteration
  Columns3 wanted;            ///< what A u was to be near in it
  Columns3 q;                 ///< n x 3, logs, the nearest to those of the start
  ConstraintSystem system;    ///< rotated by q
  RotationIterations iterations;
  std::map<Index, std::vector<Index>> reasons;  ///< see `Diagnosis::reasons`
  std::vector<Finding> findings;  ///< what is doubtful about the rotations; none where they go on from a call before
};

/// What an iteration starts from, n x 3 each, logs.
struct RotationStart {
  Columns3 field;   ///< the field of the given rotations; these stay unless points of a rigid region differ
  Columns3 before;  ///< the free rotations as found before; no rows where there are none yet
};

/// Finds rotations. Each iteration fits them to the shape, then solves for the shape: O(factor). Rigid regions with
/// several points in them turn as these decide. Kept vectors between held points do too. No solution has a larger
/// energy than the one before, with two exceptions. Regions or vectors that turn may hang together, or a vector may be
/// kept.
///
/// The search ends when `options` say so, or where the shape is not finite. `progress` may throw between iterations.
[[nodiscard]] FoundShape findShape(const FoundProblem& problem, ConstraintSystem system, RotationStart start,
                                   const RotationOptions& options, Progress& progress);

}  // namespace holdfast
