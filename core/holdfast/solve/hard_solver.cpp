// Hard constraints by elimination: equations (11) to (21).

#include <utility>

#include <holdfast/elimination/row_components.h>
#include <holdfast/solve/column_scaling.h>
#include <holdfast/solve/constrained_solver.h>
#include <holdfast/solve/corrected_solve.h>
#include <holdfast/solve/elimination_order.h>

namespace holdfast {
namespace {

class HardSolver final : public ConstrainedSolver {
 public:
  HardSolver(ConstrainedProblem problem, const SparseMatrix& Q2, ScaledColumns reduced,
             std::unique_ptr<const LeastSquaresFactor> factor)
      : problem_(std::move(problem)),
        B_(constraintMatrix(problem_.eliminated.rows, Q2.rows())),
        scaledQ2_(Q2 * reduced.scale.asDiagonal()),
        reduced_(std::move(reduced)),
        factor_(std::move(factor))
  {
  }

  [[nodiscard]] Displacement solve(const RowTargets& targets, const Columns3& f) const override
  {
    Displacement result{particular(targets), 0, 0};
    const CorrectedSolution z = correctedSolve(*factor_, reduced_.C, reduced_.scale, problem_.A->residual(f, result.u));
    parallelBlocks(result.u.rows(), [&](Index i) { result.u.row(i) += gathered(scaledQ2_, i, z.z); });
    // What rounding has left of B u = d is taken off in the span of the rows; pins have nothing left.
    const Columns3 left = targets.shifts - B_ * result.u;
    if (!left.isZero(0)) result.u += particular({left, targets.reconciled});
    result.corrections = z.corrections;
    result.accuracy = z.accuracy;
    return result;
  }

  [[nodiscard]] Index unknowns() const override { return reduced_.scale.size(); }
  [[nodiscard]] Index factorNonzeros() const override { return factor_->nonzeros(); }
  [[nodiscard]] std::string method() const override { return std::string(factor_->method()); }

 private:
  [[nodiscard]] Columns3 particular(const RowTargets& targets) const
  {
    return targets.reconciled.empty()
               ? problem_.eliminated.elimination.particular(targets.shifts)
               : problem_.eliminated.elimination.reconciledParticular(targets.reconciled, targets.shifts);
  }

  ConstrainedProblem problem_;
  SparseRows B_;
  SparseRows scaledQ2_;  // Q2 diag(scale)
  ScaledColumns reduced_;
  std::unique_ptr<const LeastSquaresFactor> factor_;
};

}  // namespace

SolverResult makeHardSolver(ConstrainedProblem problem, Backend backend)
{
  const SparseMatrix Q2 = orderedColumns(problem.eliminated.elimination.Q2(), problem.ranks);
  Result<ScaledColumns> columns = scaleColumns(product(problem.A->columns(), Q2));
  if (!columns) return {nullptr, std::move(columns.failure)};
  ScaledColumns& reduced = columns.value;
  const Columns3 probe = reduced.scale.cwiseInverse().asDiagonal() * Columns3(Q2.transpose() * problem.rest);
  FactorResult result = factorize(reduced.C, backend, probe, problem.eliminationOrder());
  if (!result) return {nullptr, std::move(result.failure)};
  return {std::make_unique<HardSolver>(std::move(problem), Q2, std::move(reduced), std::move(result.value))};
}

}  // namespace holdfast
