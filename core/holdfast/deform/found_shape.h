#pragma once
/// The shape whose rotations are found with it: local-global iteration under exact constraints.

#include <holdfast/base/progress.h>
#include <holdfast/deform/report.h>
#include <holdfast/elimination/diagnosis.h>
#include <holdfast/rotation/rotation_energy.h>
#include <holdfast/solve/constrained_solver.h>

namespace holdfast {

/// What shapes are found for.
struct FoundProblem {
  const RotationEnergy& energy;
  const SolverMesh& mesh;
  const EliminatedConstraints& eliminated;
  const ConstrainedSolver& solver;  ///< of `energy.A()` under `eliminated`
};

struct FoundShape {
  Displacement displacement;  ///< of the last iteration
  Columns3 wanted;            ///< what A u was to be near in it
  Columns3 q;                 ///< n x 3, logs, the nearest to those of the start
  ConstraintSystem system;    ///< rotated by q
  RotationIterations iterations;
};

/// What an iteration starts from, n x 3 each, logs.
struct RotationStart {
  Columns3 field;   ///< the rotation field of those that are given, which stay as they are in it
  Columns3 before;  ///< the free ones as they were found before; no rows: not yet
};

/// Finds rotations. Each iteration fits them to the shape, then solves for the shape. No solution has a larger energy
/// than the one before unless rows rotate that hold a rigid region by other constraints as well, or keep a vector. It
/// ends when `options` say so, or where the shape is not finite. `progress` may throw between iterations. O(factor) an
/// iteration.
[[nodiscard]] FoundShape findShape(const FoundProblem& problem, ConstraintSystem system, RotationStart start,
                                   const RotationOptions& options, Progress& progress);

}  // namespace holdfast
