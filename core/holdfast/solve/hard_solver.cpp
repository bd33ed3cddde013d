// Hard constraints by elimination: equations (11) to (21).

#include <algorithm>
#include <utility>

#include <holdfast/elimination/reconciliation.h>
#include <holdfast/matrices/largest_size.h>
#include <holdfast/numbers/disjoint_sets.h>
#include <holdfast/ordering/elimination_order.h>
#include <holdfast/solve/bordered_problem.h>
#include <holdfast/solve/constrained_solver.h>
#include <holdfast/threads/long_step.h>

namespace holdfast {
namespace {

// A solution leaves less of its rows than this share of its size.
constexpr double kMetByBase = 1e-10;

// Solutions by multipliers that are less accurate than this are made by another basis where that is small.
constexpr double kSufficientAccuracy = 1e-12;
// A basis with so many numbers is made and factorised in seconds.
constexpr double kMostNumbersOfQ2 = 2e7;
// One with so many takes gigabytes and minutes: only where rows are missed otherwise.
constexpr double kMostNumbersOfNeededQ2 = 2e8;
// The solver meets its rows again if a solution misses one by more than this share of the allowed residual.
constexpr double kWellMet = 0.01;

/// Returns for each of `columns` sets of columns in how many rows one of a set is the first.
Eigen::VectorXd rowsOfSets(const SparseRows& rows, DisjointSets& columns)
{
  Eigen::VectorXd counts = Eigen::VectorXd::Zero(rows.cols());
  for (Index r = 0; r < rows.rows(); ++r)
    if (const SparseRows::InnerIterator first(rows, r); first) ++counts[columns.find(first.col())];
  return counts;
}

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

  [[nodiscard]] Displacement solveFrom(Displacement&& near, const RowTargets& targets, const Columns3& f) const override
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

  [[nodiscard]] SolverResult edited(const std::shared_ptr<const EliminatedConstraints>& others) const override
  {
    Result<ReducedProblem> result = bordered(reduced_, *problem_.eliminated, *others);
    if (!result) return {nullptr, std::move(result.failure)};
    return {std::make_unique<HardSolver>(ConstrainedProblem{problem_.A, others, {}}, std::move(result.value))};
  }

  /// Returns the largest coordinate of d - B u over the rows that hold.
  [[nodiscard]] double mostMissed(const Columns3& u, const RowTargets& targets) const
  {
    const Columns3 missed = missedBy(u, targets);
    std::vector<Index> held = independentRows(problem_.eliminated->dependencies, problem_.eliminated->rows.size());
    held.insert(held.end(), targets.reconciled.begin(), targets.reconciled.end());
    double most = 0;
    for (const Index row : held) most = std::max(most, missed.row(row).cwiseAbs().maxCoeff());
    return most;
  }

  /// How many numbers the columns of large components have at most in a basis that meets all rows. Rows of Q2 and kept
  /// rows tie the columns of a component. O(entries).
  [[nodiscard]] double mostNumbersOfWholeQ2() const
  {
    const SparseRows& Q2 = reduced_->C->Q2()->rows();
    DisjointSets sets(Q2.cols());
    for (const SparseRows* rows : {&Q2, &reduced_->C->K()})
      for (Index r = 0; r < rows->rows(); ++r)
        for (SparseRows::InnerIterator entry(*rows, r); entry; ++entry)
          sets.unite(rows->innerIndexPtr()[rows->outerIndexPtr()[r]], entry.col());
    Eigen::VectorXd columns = Eigen::VectorXd::Zero(Q2.cols());
    for (Index k = 0; k < Q2.cols(); ++k) ++columns[sets.find(k)];
    const Eigen::ArrayXd kept = rowsOfSets(reduced_->C->K(), sets);
    return (kept > 0).select(rowsOfSets(Q2, sets).array() * (columns.array() - kept), 0).sum();
  }

  [[nodiscard]] Index keptRows() const override { return reduced_->kept; }
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

  /// Tells whether `base` meets the rows that the base of this solver has as well: nothing else has changed.
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

using OwnSolver = Result<std::unique_ptr<const HardSolver>>;

/// With the rows `kept` of the elimination in the system, or with none where that is empty.
OwnSolver hardSolver(ConstrainedProblem problem, Backend backend, SparseMatrix Q2, const std::vector<Index>& kept)
{
  currentStep()->stopIfLeftBehind();
  Q2 = orderedColumns(Q2, problem.ranks);
  std::vector<RowTerms> rows;
  rows.reserve(kept.size());
  for (const Index row : kept) rows.push_back(problem.eliminated->rows[row]);
  SparseRows K = constraintMatrix(rows, Q2.rows()) * Q2;
  const EliminationOrder order = orderFor(problem, Q2);
  Result<ReducedProblem> reduced = makeReducedProblem(problem.A, std::move(Q2), std::move(K), RowsBelow::Kept,
                                                      std::move(problem.rest), backend, order);
  if (!reduced) return {nullptr, std::move(reduced.failure)};
  return {std::make_unique<HardSolver>(std::move(problem), std::move(reduced.value))};
}

/// Makes a solver whose basis spans what all rows leave free.
OwnSolver solverByWholeQ2(ConstrainedProblem problem, Backend backend)
{
  SparseMatrix Q2 = problem.eliminated->elimination.wholeQ2();
  return hardSolver(std::move(problem), backend, std::move(Q2), {});
}

/// The rows of large components have multipliers, until a solution shows that these take digits: nearly dependent rows
/// do. From then on it solves by the basis of all rows.
class MultipliersFirst final : public ConstrainedSolver {
 public:
  MultipliersFirst(ConstrainedProblem problem, std::unique_ptr<const HardSolver> byMultipliers)
      : problem_(std::move(problem)),
        mostMissed_(kPromisedResidual / 2 * largestSize(problem_.rest)),
        solver_(std::move(byMultipliers))
  {
  }

  [[nodiscard]] Displacement solve(const RowTargets& targets, const Columns3& f) const override
  {
    return sufficient(solver_->solve(targets, f), targets, f);
  }

  [[nodiscard]] Displacement solveFrom(Displacement&& near, const RowTargets& targets, const Columns3& f) const override
  {
    return sufficient(solver_->solveFrom(std::move(near), targets, f), targets, f);
  }

  void meet(const RowTargets& targets, Columns3& u) const override { solver_->meet(targets, u); }
  [[nodiscard]] SolverResult edited(const std::shared_ptr<const EliminatedConstraints>& others) const override
  {
    return solver_->edited(others);
  }

  [[nodiscard]] Index keptRows() const override { return solver_->keptRows(); }
  [[nodiscard]] Index unknowns() const override { return solver_->unknowns(); }
  [[nodiscard]] Index factorNonzeros() const override { return solver_->factorNonzeros(); }
  [[nodiscard]] std::string method() const override { return solver_->method(); }

 private:
  /// `result`, or the solution by the other basis. Its last step leaves of the rows what the factor leaves of K z = 0.
  [[nodiscard]] Displacement sufficient(Displacement result, const RowTargets& targets, const Columns3& f) const
  {
    if (solver_->mostMissed(result.u, targets) > kWellMet * mostMissed_) solver_->meet(targets, result.u);
    if (isDecided_ || !wantsWholeQ2(result, targets)) return result;
    isDecided_ = true;
    OwnSolver whole = solverByWholeQ2(problem_, Backend::Holdfast);
    if (!whole) return result;
    solver_ = std::move(whole.value);
    return solver_->solve(targets, f);
  }

  [[nodiscard]] bool wantsWholeQ2(const Displacement& result, const RowTargets& targets) const
  {
    if (!(solver_->mostMissed(result.u, targets) <= mostMissed_))
      return solver_->mostNumbersOfWholeQ2() <= kMostNumbersOfNeededQ2;
    return result.accuracy > kSufficientAccuracy && solver_->mostNumbersOfWholeQ2() <= kMostNumbersOfQ2;
  }

  ConstrainedProblem problem_;
  double mostMissed_;  // half of what is promised, or less: positions are rounded
  mutable std::unique_ptr<const HardSolver> solver_;
  mutable bool isDecided_ = false;
};

}  // namespace

SolverResult makeHardSolver(ConstrainedProblem problem, Backend backend)
{
  const Elimination& elimination = problem.eliminated->elimination;
  const std::vector<Index> kept = elimination.kept();
  if (kept.empty()) {
    OwnSolver result = hardSolver(std::move(problem), backend, elimination.Q2(), kept);
    return {std::move(result.value), std::move(result.failure)};
  }
  // Only our own factorisation has multipliers.
  if (backend == Backend::Holdfast)
    if (OwnSolver result = hardSolver(problem, backend, elimination.Q2(), kept))
      return {std::make_unique<MultipliersFirst>(std::move(problem), std::move(result.value))};
  OwnSolver result = solverByWholeQ2(std::move(problem), backend);
  return {std::move(result.value), std::move(result.failure)};
}

}  // namespace holdfast
