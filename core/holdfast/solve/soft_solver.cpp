// Soft constraints by weighted least squares: equations (7) and (8), for comparison with hard ones.

#include <utility>

#include <holdfast/elimination/row_components.h>
#include <holdfast/solve/column_scaling.h>
#include <holdfast/solve/constrained_solver.h>
#include <holdfast/solve/corrected_solve.h>
#include <holdfast/solve/elimination_order.h>

namespace holdfast {
namespace {

SparseMatrix stacked(const SparseMatrix& top, const SparseMatrix& bottom)
{
  SparseRows result(top.rows() + bottom.rows(), top.cols());
  result.topRows(top.rows()) = top;
  result.bottomRows(bottom.rows()) = bottom;
  return result;
}

class SoftSolver final : public ConstrainedSolver {
 public:
  SoftSolver(double weight, SparseMatrix spread, ScaledColumns stacked,
             std::unique_ptr<const LeastSquaresFactor> factor)
      : weight_(weight), spread_(std::move(spread)), stacked_(std::move(stacked)), factor_(std::move(factor))
  {
  }

  [[nodiscard]] Displacement solve(const RowTargets& targets, const Columns3& f) const override
  {
    Columns3 rightSides(f.rows() + targets.shifts.rows(), 3);
    rightSides << f, weight_ * targets.shifts;
    const CorrectedSolution z = correctedSolve(*factor_, stacked_.C, stacked_.scale, rightSides);
    return {spread_ * (stacked_.scale.asDiagonal() * z.z), z.corrections, z.accuracy};
  }

  [[nodiscard]] Index unknowns() const override { return spread_.cols(); }
  [[nodiscard]] Index factorNonzeros() const override { return factor_->nonzeros(); }
  [[nodiscard]] std::string method() const override { return std::string(factor_->method()); }

 private:
  double weight_;
  SparseMatrix spread_;  // n x free unknowns, identity columns
  ScaledColumns stacked_;
  std::unique_ptr<const LeastSquaresFactor> factor_;
};

}  // namespace

SolverResult makeSoftSolver(ConstrainedProblem problem, Backend backend, double weight)
{
  const EliminatedConstraints& eliminated = *problem.eliminated;
  const SparseMatrix& A = problem.A->columns();
  SparseMatrix spread = orderedColumns(Elimination({}, {}, A.cols(), eliminated.isHeld).Q2(), problem.ranks);
  const SparseMatrix all = stacked(A, weight * constraintMatrix(eliminated.rows, A.cols()));
  Result<ScaledColumns> columns = scaleColumns(all * spread);
  if (!columns) return {nullptr, std::move(columns.failure)};
  ScaledColumns& scaled = columns.value;
  const Columns3 probe = scaled.scale.cwiseInverse().asDiagonal() * Columns3(spread.transpose() * problem.rest);
  FactorResult result = factorize(scaled.C, backend, probe, problem.eliminationOrder());
  if (!result) return {nullptr, std::move(result.failure)};
  return {std::make_unique<SoftSolver>(weight, std::move(spread), std::move(scaled), std::move(result.value))};
}

}  // namespace holdfast
