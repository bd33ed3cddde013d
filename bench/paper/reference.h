#pragma once
/// \file
/// What solvers are judged by: solutions with many more digits than a double holds, and the condition of the problem.

#include <holdfast/solve/bordered_problem.h>

#include "bench/paper/bent_mesh.h"

namespace holdfast::paper {

/// How constraints are met, as a row of a table.
struct Method {
  SolverKind kind = SolverKind::Hard;
  double weight = 0;  ///< of soft constraints
};

/// What is factorised for `method`, as the product does it: for Lagrange multipliers, which have the solution of hard
/// constraints, that of hard ones. Its factor corrects the reference.
[[nodiscard]] Result<ReducedProblem> reducedProblem(const BentMesh& bent, const BentProblem& problem,
                                                    const Method& method);

/// A solution and how far the last correction moved it.
struct Reference {
  Columns3 u;                 ///< rounded to double
  double lastCorrection = 1;  ///< relative to the largest displacement
};

/// Minimises |A u - f| under B u = d, or |A u - f|^2 + w^2 |B u - d|^2. A, f, B and d are taken as exact; unknown and
/// residuals are of quadruple precision (113 bits), corrections are solved for by the factor of `reduced`, in doubles.
/// Ends where corrections no longer shrink: the last one bounds the error as far as the factor contracts.
[[nodiscard]] Reference quadrupleSolution(const BentMesh& bent, const BentProblem& problem,
                                          const ReducedProblem& reduced, const Method& method);

/// The condition number, in the 2-norm, of the normal equations as they are before columns are scaled. Estimated to
/// some ten per cent by power iteration with the matrix and with the factor of `reduced`, which has so many
/// `equations`.
[[nodiscard]] double conditionOf(const ReducedProblem& reduced);

}  // namespace holdfast::paper
