// Soft constraints by weighted least squares: equations (7) and (8), for comparison with hard ones.

#include <holdfast/ordering/elimination_order.h>
#include <holdfast/solve/bordered_problem.h>
#include <holdfast/solve/constrained_solver.h>

namespace holdfast {
namespace {

class SoftSolver final : public ConstrainedSolver {
 public:
  SoftSolver(double weight, ReducedProblem reduced) : weight_(weight), reduced_(std::move(reduced)) {}

  [[nodiscard]] Displacement solve(const RowTargets& targets, const Columns3& f) const override
  {
    Columns3 rightSides(f.rows() + targets.shifts.rows(), 3);
    rightSides << f, weight_ * targets.shifts;
    const CorrectedSolution z = correctedSolve(*reduced_.factor, *reduced_.C, reduced_.scale, rightSides);
    return {reduced_.C->spread(z.z), z.corrections, z.accuracy};
  }

  [[nodiscard]] Index unknowns() const override { return reduced_.scale.size(); }
  [[nodiscard]] Index factorNonzeros() const override { return reduced_.factor->nonzeros(); }
  [[nodiscard]] std::string method() const override { return std::string(reduced_.factor->method()); }

 private:
  double weight_;
  ReducedProblem reduced_;  // Q2 has an identity column for each free unknown
};

}  // namespace

SolverResult makeSoftSolver(ConstrainedProblem problem, Backend backend, double weight)
{
  const EliminatedConstraints& eliminated = *problem.eliminated;
  const Index size = problem.A->cols();
  SparseMatrix spread = orderedColumns(Elimination({}, {}, size, eliminated.isHeld).Q2(), problem.ranks);
  SparseRows below = weight * (constraintMatrix(eliminated.rows, size) * spread);
  Result<ReducedProblem> reduced =
      makeReducedProblem(problem.A, std::move(spread), std::move(below), RowsBelow::Equations, std::move(problem.rest),
                         backend, problem.eliminationOrder());
  if (!reduced) return {nullptr, std::move(reduced.failure)};
  return {std::make_unique<SoftSolver>(weight, std::move(reduced.value))};
}

}  // namespace holdfast
