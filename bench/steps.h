#pragma once
/// \file
/// The three costs of a deformation (docs/design.md) as calls: set-up, decomposition (`eliminate`, `factorized`),
/// solution.

#include <memory>

#include <holdfast/deform/model.h>
#include <holdfast/operators/operators.h>
#include <holdfast/solve/constrained_solver.h>

namespace holdfast::bench {

/// What set-up makes: nothing of it depends on the solver.
struct SetUp {
  Operators operators;
  ConstraintSystem system;
};

[[nodiscard]] SetUp setUp(const Model& model, const ConstraintList& constraints);

/// The solver. Throws std::runtime_error with the reason where there is none.
[[nodiscard]] std::unique_ptr<const ConstrainedSolver> factorized(const Model& model, const SetUp& setUp,
                                                                  const EliminatedConstraints& eliminated,
                                                                  const SolverOptions& options);

/// One solution, at the targets of `setUp`, no detail turned.
[[nodiscard]] Displacement solution(const SetUp& setUp, const ConstrainedSolver& solver);

/// Bytes of the numbers in the solver's factor, in MiB.
[[nodiscard]] double factorMiB(const ConstrainedSolver& solver);

}  // namespace holdfast::bench
