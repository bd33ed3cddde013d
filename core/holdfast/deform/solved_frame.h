#pragma once
/// One frame: from the rows of a list of constraints, and a factorization that serves them, to a result.

#include <memory>

#include <holdfast/deform/constraint_factorization.h>
#include <holdfast/deform/deform_details.h>

namespace holdfast {

/// What a frame is solved for.
struct FrameProblem {
  const Model& model;
  const DeformOptions& options;
  const ModelOperators& operators;
  std::shared_ptr<const ConstraintLabels> labels;  ///< of the list
  /// The rotations of the last frame (n x 3, logs), from which this one goes on; null where it starts anew.
  const Columns3* before = nullptr;
};

/// Iterations by which a frame goes on from the rotations of the last one: they take about as long as drawing the
/// picture.
inline constexpr int kIterationsOfFrame = 2;

struct SolvedFrame {
  DeformResult result;  ///< without the seconds that went before
  /// The distance that rows need from the others so that hard constraints can be met; 0 if they are. See
  /// `FactorStore::withFewerRows`.
  double neededDistance = 0;
};

/// Finds rotations, turns the rows with them, solves, and judges the rows at the positions that a file gets. `by`
/// serves `system`. Throws what `progress` throws.
[[nodiscard]] SolvedFrame solveFrame(const FrameProblem& problem, ConstraintSystem system, ConstraintFactorization& by,
                                     Progress& progress);

}  // namespace holdfast
