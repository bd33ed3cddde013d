#pragma once
/// The solvers of rows with directions: one for each set of axes, and together one displacement.

#include <memory>
#include <vector>

#include <holdfast/elimination/axis_elimination.h>
#include <holdfast/solve/constrained_solver.h>

namespace holdfast {

/// The problem that the solvers of all sets of axes share.
struct AxisProblem {
  std::shared_ptr<const EnergyMatrix> A;  ///< weighted rows, n x n
  std::shared_ptr<const EliminatedByAxes> eliminated;
  Columns3 rest;           ///< n x 3, a typical solution to measure factors on
  std::vector<int> ranks;  ///< `eliminationRanks`; empty: the factorisation finds an order of its own
};

/// One solver for each part of an elimination, in its order. The energy is a sum over the parts, so each is solved
/// alone. Where there is one part, all calls are calls of its solver.
class AxisSolvers {
 public:
  using Solvers = std::vector<std::shared_ptr<const ConstrainedSolver>>;

  AxisSolvers(std::shared_ptr<const EliminatedByAxes> eliminated, Solvers solvers);

  [[nodiscard]] const ConstrainedSolver& of(std::size_t part) const { return *solvers_[part]; }
  [[nodiscard]] const EliminatedByAxes& eliminated() const noexcept { return *eliminated_; }

  /// Solves as `ConstrainedSolver::solve`. `targets` are those of the parts, `f` is in model coordinates, and so is the
  /// result. Its multipliers are those of the parts, one below the other.
  [[nodiscard]] Displacement solve(const std::vector<RowTargets>& targets, const Columns3& f) const;

  /// Solves as `ConstrainedSolver::solveFrom`.
  [[nodiscard]] Displacement solveFrom(Displacement&& near, const std::vector<RowTargets>& targets,
                                       const Columns3& f) const;

  /// Takes what rounding has left of B u = d off `u`, as `ConstrainedSolver::meet`.
  void meet(const std::vector<RowTargets>& targets, Columns3& u) const;

  /// Returns the displacement that `ofParts` are together, each by coordinates of the frame.
  [[nodiscard]] Displacement joined(std::vector<Displacement> ofParts) const;

  /// Makes solvers under `others` from the decompositions of these, see `ConstrainedSolver::edited`. A part whose rows
  /// stay keeps its solver. Fails where a part cannot be edited, or axes are others.
  [[nodiscard]] Result<std::shared_ptr<const AxisSolvers>> edited(
      const std::shared_ptr<const EliminatedByAxes>& others) const;

  /// Returns the largest number of unknowns of a system that is solved.
  [[nodiscard]] Index unknowns() const;
  [[nodiscard]] Index factorNonzeros() const;
  [[nodiscard]] std::string method() const { return solvers_.front()->method(); }

 private:
  [[nodiscard]] Displacement partOf(const Displacement& near, std::size_t part) const;

  std::shared_ptr<const EliminatedByAxes> eliminated_;
  Solvers solvers_;
};

using AxisSolversResult = Result<std::shared_ptr<const AxisSolvers>>;

/// Makes a solver for each part, one after the other.
[[nodiscard]] AxisSolversResult makeAxisSolvers(AxisProblem problem, const SolverOptions& options);

}  // namespace holdfast
