#pragma once
/// The three ways to solve min |A u - f| under B u = d, behind one interface: hard, soft, Lagrange.

#include <memory>
#include <optional>
#include <string>

#include <holdfast/elimination/diagnosis.h>
#include <holdfast/operators/energy_matrix.h>
#include <holdfast/solve/least_squares_factor.h>

namespace holdfast {

/// A displacement of the unknowns from rest. The paper solves for positions. The displacement solves the same problem,
/// with the rest shape taken off both sides. It keeps the digits that positions would spend on that shape.
struct Displacement {
  Columns3 u;                 ///< n x 3, model units
  int corrections = 0;        ///< refinement steps
  double accuracy = 0;        ///< estimated relative error, from residuals through A itself: see `correctedSolve`
  double left = 0;            ///< the share of an error that the factor leaves, see `CorrectedSolution`; 0: not known
  Columns3 multipliers = {};  ///< of rows kept in the solver's system; as linear in the targets as `u`
};

class ConstrainedSolver;
using SolverResult = Result<std::unique_ptr<const ConstrainedSolver>>;

/// A solver holds one decomposition, for any number of solutions with the same rows. Another set of constraints makes
/// another object.
class ConstrainedSolver {
 public:
  virtual ~ConstrainedSolver() = default;

  /// Solves for these targets. `f` (n x 3) is what A u should be near: 0 when no detail is rotated. O(factor). One
  /// thread at a time may call it.
  [[nodiscard]] virtual Displacement solve(const RowTargets& targets, const Columns3& f) const = 0;

  /// Solves like `solve`, from a solution `near` for about the same. Where that is near enough it takes half the time,
  /// and the result is as accurate. The last digits depend on `near`.
  [[nodiscard]] virtual Displacement solveFrom(Displacement&& /*near*/, const RowTargets& targets,
                                               const Columns3& f) const
  {
    return solve(targets, f);
  }

  /// Solves like `solve`, from `base`, in little more than half of the time. `base` is the last solution, under the
  /// same f, of the solver that this one was `edited` from. Returns none where the rows that both solvers have ask for
  /// something else now.
  [[nodiscard]] virtual std::optional<Displacement> solveEdited(const Displacement& /*base*/,
                                                                const RowTargets& /*targets*/,
                                                                const Columns3& /*f*/) const
  {
    return std::nullopt;
  }

  /// Takes what rounding has left of B u = d off `u`, where the solver holds its rows exactly.
  virtual void meet(const RowTargets& /*targets*/, Columns3& /*u*/) const {}

  /// Makes a solver under `others` from this one's decomposition. It adds a border of one column for each row more and
  /// for each row fewer. Fails where these are too many, or where the solver does not do that. O(factor) for three
  /// rows.
  [[nodiscard]] virtual SolverResult edited(const std::shared_ptr<const EliminatedConstraints>& others) const;

  /// Returns how many rows `Displacement::multipliers` of the next solution has, unless the solver goes on without.
  [[nodiscard]] virtual Index keptRows() const { return 0; }

  /// Returns how many unknowns the system that is solved has, for each coordinate.
  [[nodiscard]] virtual Index unknowns() const = 0;
  [[nodiscard]] virtual Index factorNonzeros() const = 0;
  /// Returns how the problem is solved, in a user's words.
  [[nodiscard]] virtual std::string method() const = 0;

 protected:
  ConstrainedSolver() = default;
  ConstrainedSolver(const ConstrainedSolver&) = default;
  ConstrainedSolver& operator=(const ConstrainedSolver&) = default;
};

/// What the solvers are made of.
struct ConstrainedProblem {
  std::shared_ptr<const EnergyMatrix> A;  ///< weighted rows, n x n
  std::shared_ptr<const EliminatedConstraints> eliminated;
  Columns3 rest;                ///< n x 3, a typical solution to measure factors on
  std::vector<int> ranks = {};  ///< `eliminationRanks`; empty: the factorisation finds an order of its own

  [[nodiscard]] EliminationOrder eliminationOrder() const
  {
    return ranks.empty() ? EliminationOrder::ToBeFound : EliminationOrder::OfColumns;
  }
};

[[nodiscard]] SolverResult makeSolver(ConstrainedProblem problem, const SolverOptions& options);

/// `makeSolver` calls one of these three.
[[nodiscard]] SolverResult makeHardSolver(ConstrainedProblem problem, Backend backend);
[[nodiscard]] SolverResult makeSoftSolver(ConstrainedProblem problem, Backend backend, double weight);
[[nodiscard]] SolverResult makeLagrangeSolver(const ConstrainedProblem& problem, Backend backend);

}  // namespace holdfast
