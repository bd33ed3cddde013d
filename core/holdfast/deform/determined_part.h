#pragma once
/// The part of a displacement that constraints determine, and what rounding loses of it.

#include <vector>

#include <holdfast/constraints/constraint_system.h>
#include <holdfast/solve/axis_solvers.h>

namespace holdfast {

/// The relative error of a displacement that follows from its rows, and the row that may lose most.
struct DeterminedPart {
  double accuracy = 0;  ///< estimated, relative to the largest displacement; 0 where nothing moves
  Index row = -1;       ///< place in the system; none where the accuracy is 0
};

/// Estimates the error of the part of `u` (n x 3) that rows determine. A row multiplies the rounding of its target, and
/// of the displacements of its unknowns, by its sensitivity (`Elimination::sensitivities`, 0 for rows that are left
/// out). Rows that nearly depend on one another have large ones.
///
/// Where this bound exceeds 1e-12 the error is measured. `solvers` take off what is left of the rows at `u`, and the
/// size of that step counts. `targets` are those of the diagnosis; what they reconcile is met too. Targets of rows are
/// taken as they are stated. O(terms), and beyond the bound the cost of `ConstrainedSolver::meet`.
[[nodiscard]] DeterminedPart determinedPart(const ConstraintSystem& system, const std::vector<double>& sensitivities,
                                            const AxisSolvers& solvers, const std::vector<RowTargets>& targets,
                                            const Columns3& u);

}  // namespace holdfast
