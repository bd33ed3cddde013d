// Hard constraints by elimination: equations (11) to (21).

#include <holdfast/base/largest_size.h>
#include <holdfast/base/long_step.h>
#include <holdfast/elimination/reconciliation.h>
#include <holdfast/ordering/elimination_order.h>
#include <holdfast/solve/bordered_problem.h>
#include <holdfast/solve/constrained_solver.h>

namespace holdfast {
namespace {

// A solution leaves less of its rows than this share of its size.
constexpr double kMetByBase = 1e-10;

class HardSolver final : public ConstrainedSolver {
 public:
  HardSolver(ConstrainedProblem problem, ReducedProblem reduced)
      : problem_(std::move(problem)),
        B_(constraintMatrix(problem_.eliminated->rows, problem_.A->cols())),
        reduced_(std::make_shared<const ReducedProblem>(std::move(reduced)))
  {
  }

  [[nodiscard]] Displacement solve(const RowTargets& targets, const Columns3& f) const override
  {
    return solved({particular(targets)}, f, {});
  }

  [[nodiscard]] Displacement solveFrom(Displacement near, const RowTargets& targets, const Columns3& f) const override
  {
    if (near.left == 0) return solve(targets, f);  // a difference does not tell what is left of all
    meet(targets, near.u);
    KnownSolution known{largestSize(near.u), std::move(near.multipliers), near.left};
    return solved(std::move(near), f, known);
  }

  [[nodiscard]] std::optional<Displacement> solveEdited(const Displacement& base, const RowTargets& targets,
                                                        const Columns3& f) const override
  {
    const Columns3 missed = missedBy(base.u, targets);
    if (!targets.reconciled.empty() || !isOfBase(base, missed)) return std::nullopt;
    const Index unknowns = reduced_->scale.size();
    const Columns3 z = reduced_->border->stepFromBase(base.u, f, missed);
    Displacement near{reduced_->C->spread(z.topRows(unknowns))};
    parallelBlocks(near.u.rows(), [&](Index i) { near.u.row(i) += base.u.row(i); });
    KnownSolution known{largestSize(near.u), z.bottomRows(reduced_->kept), base.left,
                        largestSize(reduced_->scale, z.topRows(unknowns))};
    if (base.left == 0 && !known.isTelling()) return std::nullopt;
    known.multipliers.topRows(base.multipliers.rows()) += base.multipliers;
    meet(targets, near.u);
    Displacement result = solved(std::move(near), f, known);
    if (!known.isTelling()) result.left = 0;
    return result;
  }

  /// In the span of the rows; pins have nothing left.
  void meet(const RowTargets& targets, Columns3& u) const override
  {
    Columns3 left = missedBy(u, targets);
    if (left.isZero(0)) return;
    const Columns3 step = particular({std::move(left), targets.reconciled});
    parallelBlocks(u.rows(), [&](Index i) { u.row(i) += step.row(i); });
  }

  [[nodiscard]] SolverResult edited(std::shared_ptr<const EliminatedConstraints> others) const override
  {
    Result<ReducedProblem> result = bordered(reduced_, *problem_.eliminated, *others);
    if (!result) return {nullptr, std::move(result.failure)};
    return {
        std::make_unique<HardSolver>(ConstrainedProblem{problem_.A, std::move(others), {}}, std::move(result.value))};
  }

  [[nodiscard]] Index unknowns() const override { return reduced_->scale.size() + reduced_->kept; }
  [[nodiscard]] Index factorNonzeros() const override { return reduced_->factor->nonzeros(); }
  [[nodiscard]] std::string method() const override { return std::string(reduced_->factor->method()); }

 private:
  /// d - B u.
  [[nodiscard]] Columns3 missedBy(const Columns3& u, const RowTargets& targets) const
  {
    Columns3 missed(B_.rows(), 3);
    parallelBlocks(missed.rows(), [&](Index r) { missed.row(r) = targets.shifts.row(r) - gathered(B_, r, u); });
    return missed;
  }

  /// Whether `base` meets the rows that the base of this solver has as well: nothing else has changed.
  [[nodiscard]] bool isOfBase(const Displacement& base, const Columns3& missed) const
  {
    if (reduced_->border == nullptr) return false;
    const std::vector<Index>& added = reduced_->border->added();
    if (base.multipliers.rows() + static_cast<Index>(added.size()) != reduced_->kept) return false;
    std::vector<char> isOfBoth(problem_.eliminated->rows.size(), 0);
    for (const Index row : independentRows(problem_.eliminated->dependencies, isOfBoth.size())) isOfBoth[row] = 1;
    for (const Index row : added) isOfBoth[row] = 0;
    const double rounding = kMetByBase * largestSize(base.u);
    for (std::size_t r = 0; r < isOfBoth.size(); ++r)
      if (isOfBoth[r] != 0 && !(missed.row(static_cast<Index>(r)).cwiseAbs().maxCoeff() <= rounding)) return false;
    return true;
  }

  /// `result` meets the rows, and goes on to do so.
  [[nodiscard]] Displacement solved(Displacement result, const Columns3& f, const KnownSolution& known) const
  {
    Columns3 missed = problem_.A->residual(f, result.u);
    missed.conservativeResizeLike(Columns3::Zero(missed.rows() + reduced_->kept, 3));
    CorrectedSolution z =
        correctedSolve(*reduced_->factor, *reduced_->C, reduced_->scale, missed, reduced_->kept, known);
    const Columns3 step = reduced_->C->spread(z.z);
    parallelBlocks(result.u.rows(), [&](Index i) { result.u.row(i) += step.row(i); });
    result.corrections = z.corrections;
    result.accuracy = z.accuracy;
    result.left = z.left;
    result.multipliers = std::move(z.multipliers);
    return result;
  }

  [[nodiscard]] Columns3 particular(const RowTargets& targets) const
  {
    if (!targets.reconciled.empty())
      return reconciledParticular(*problem_.eliminated, targets.reconciled, targets.shifts);
    if (targets.particular.rows() > 0) return targets.particular;
    return problem_.eliminated->elimination.particular(targets.shifts);
  }

  ConstrainedProblem problem_;
  SparseRows B_;
  std::shared_ptr<const ReducedProblem> reduced_;
};

/// Where most unknowns of the mesh are sums of those that are left, these are tied to more than their neighbours, and
/// an order of their own leaves half as many entries in the factor as that of the mesh.
EliminationOrder orderFor(const ConstrainedProblem& problem, const SparseMatrix& Q2)
{
  Index sums = 0;
  for (Index k = 0; k < Q2.cols(); ++k)
    if (Q2.col(k).nonZeros() > 1) ++sums;
  return 2 * sums > Q2.cols() ? EliminationOrder::ToBeFound : problem.eliminationOrder();
}

/// With the rows `kept` of the elimination in the system, or with none where that is empty.
SolverResult hardSolver(ConstrainedProblem problem, Backend backend, SparseMatrix Q2, const std::vector<Index>& kept)
{
  currentStep()->stopIfLeftBehind();
  Q2 = orderedColumns(Q2, problem.ranks);
  std::vector<RowTerms> rows;
  for (const Index row : kept) rows.push_back(problem.eliminated->rows[row]);
  SparseRows K = constraintMatrix(rows, Q2.rows()) * Q2;
  const EliminationOrder order = orderFor(problem, Q2);
  Result<ReducedProblem> reduced = makeReducedProblem(problem.A, std::move(Q2), std::move(K), RowsBelow::Kept,
                                                      std::move(problem.rest), backend, order);
  if (!reduced) return {nullptr, std::move(reduced.failure)};
  return {std::make_unique<HardSolver>(std::move(problem), std::move(reduced.value))};
}

}  // namespace

SolverResult makeHardSolver(ConstrainedProblem problem, Backend backend)
{
  const Elimination& elimination = problem.eliminated->elimination;
  const std::vector<Index> kept = elimination.kept();
  if (kept.empty()) return hardSolver(std::move(problem), backend, elimination.Q2(), kept);
  // Only our own factorisation has multipliers.
  if (backend == Backend::Holdfast)
    if (SolverResult result = hardSolver(problem, backend, elimination.Q2(), kept)) return result;
  return hardSolver(std::move(problem), backend, elimination.wholeQ2(), {});
}

}  // namespace holdfast
