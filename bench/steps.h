#pragma once
/// \file
/// The three costs of a deformation (docs/design.md) as calls: set-up, decomposition (`eliminate`, `factorized`),
/// solution.

#include <memory>
#include <vector>

#include <holdfast/deform/model.h>
#include <holdfast/operators/operators.h>
#include <holdfast/ordering/elimination_order.h>
#include <holdfast/solve/constrained_solver.h>

namespace holdfast::bench {

/// What set-up makes: nothing of it depends on the solver.
struct SetUp {
  std::shared_ptr<const EnergyMatrix> A;
  std::vector<int> ranks;
  ConstraintSystem system;
};

[[nodiscard]] SetUp setUp(const Model& model, const ConstraintList& constraints);

/// The solver. Throws std::runtime_error with the reason where there is none.
[[nodiscard]] std::unique_ptr<const ConstrainedSolver> factorized(const Model& model, const SetUp& setUp,
                                                                  const EliminatedConstraints& eliminated,
                                                                  SolverKind kind);

/// One solution, at the targets of `setUp`, no detail turned.
Displacement solution(const SetUp& setUp, const ConstrainedSolver& solver);

/// Bytes of the numbers in the solver's factor, in MiB.
[[nodiscard]] double factorMiB(const ConstrainedSolver& solver);

/// The lower triangle of the normal equations under `constraints`, its columns in our order of elimination.
[[nodiscard]] SparseMatrix normalEquations(const Model& model, const ConstraintList& constraints);

}  // namespace holdfast::bench
