// Hard constraints by elimination: equations (11) to (21).

#include <utility>

#include <holdfast/solve/column_scaling.h>
#include <holdfast/solve/constraint_matrix.h>
#include <holdfast/solve/corrected_solve.h>
#include <holdfast/solve/deformation_solver.h>

namespace holdfast {
namespace {

class HardSolver final : public DeformationSolver {
 public:
  HardSolver(DeformationProblem problem, ScaledColumns reduced, std::unique_ptr<const LeastSquaresFactor> factor)
      : problem_(std::move(problem)),
        B_(constraintMatrix(problem_.eliminated.rows, problem_.A.cols())),
        reduced_(std::move(reduced)),
        factor_(std::move(factor))
  {
  }

  [[nodiscard]] Displacement solve(const RowTargets& targets, const Columns3& f) const override
  {
    Displacement result{particular(targets), 0, 0};
    const CorrectedSolution z = correctedSolve(*factor_, *reduced_.C, reduced_.scale, f - problem_.A * result.u);
    result.u += problem_.eliminated.elimination.Q2() * (reduced_.scale.asDiagonal() * z.z);
    // What rounding has left of B u = d is taken off in the span of the rows; pins have nothing left.
    result.u += particular({targets.shifts - B_ * result.u, targets.reconciled});
    result.corrections = z.corrections;
    result.accuracy = z.accuracy;
    return result;
  }

  [[nodiscard]] Index unknowns() const override { return reduced_.C->cols(); }
  [[nodiscard]] Index factorNonzeros() const override { return factor_->nonzeros(); }
  [[nodiscard]] std::string method() const override { return std::string(factor_->method()); }

 private:
  [[nodiscard]] Columns3 particular(const RowTargets& targets) const
  {
    return targets.reconciled.empty()
               ? problem_.eliminated.elimination.particular(targets.shifts)
               : problem_.eliminated.elimination.reconciledParticular(targets.reconciled, targets.shifts);
  }

  DeformationProblem problem_;
  SparseMatrix B_;
  ScaledColumns reduced_;
  std::unique_ptr<const LeastSquaresFactor> factor_;
};

}  // namespace

DecompositionAttempt makeHardSolver(DeformationProblem problem, Backend backend)
{
  const SparseMatrix& Q2 = problem.eliminated.elimination.Q2();
  ScaledColumns reduced = scaleColumns(problem.A * Q2);
  if (!reduced.failure.empty()) return {nullptr, std::move(reduced.failure)};
  const Columns3 probe = reduced.scale.cwiseInverse().asDiagonal() * Columns3(Q2.transpose() * problem.rest);
  FactorAttempt attempt = factorize(reduced.C, backend, probe);
  if (attempt.factor == nullptr) return {nullptr, std::move(attempt.failure)};
  return {std::make_unique<HardSolver>(std::move(problem), std::move(reduced), std::move(attempt.factor)), {}};
}

}  // namespace holdfast
