#include "holdfast/solve/moved_solutions.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <optional>
#include <utility>

#include <holdfast/threads/parallel.h>

namespace holdfast {
namespace {

constexpr int kGroups = 3;
constexpr double kRoundings = 8;
constexpr Index kSampled = 400;
constexpr std::size_t kAnswers = 8;  // smooth functions of an angle: a hand that turns it fast stays near their span
constexpr double kDependent = 1e-9;  // answers with a smaller share of their own would take digits
constexpr double kFar = 4;           // diagonals: larger differences would take digits

/// Some rows of f and of the shifts: enough to find what they are sums of.
Eigen::VectorXd sampled(const RowTargets& targets, const Columns3& f)
{
  Eigen::VectorXd sample;
  for (const Columns3* all : {&f, &targets.shifts}) {
    const Index step = std::max<Index>(1, all->rows() / kSampled);
    const Index before = sample.size();
    const Index count = (all->rows() + step - 1) / step;
    sample.conservativeResize(before + 3 * count);
    for (Index k = 0; k < count; ++k) sample.segment<3>(before + 3 * k) = all->row(k * step);
  }
  return sample;
}

bool areSame(const Columns3& a, const Columns3& b)
{
  std::atomic<bool> isSame = a.rows() == b.rows();
  if (isSame)
    parallelBlocks(a.rows(), [&](Index i) {
      if (isSame && a.row(i) != b.row(i)) isSame = false;
    });
  return isSame;
}

}  // namespace

MovedSolutions::MovedSolutions(const SolverMesh& mesh)
    : rounding_(kRoundings * std::numeric_limits<double>::epsilon() * mesh.largestCoordinate),
      farthest_(kFar * mesh.diagonal)
{
}

MovedSolutions::MovedSolutions(const SolverMesh& mesh, const MovedSolutions& base) : MovedSolutions(mesh)
{
  wanted_ = base.wanted_;
  base_ = base.last_;
}

std::optional<MovedSolutions::Moves> MovedSolutions::movesOf(const Columns3& asked, double rounding)
{
  Moves moves;
  int groups = 0;
  moves.groupOf.reserve(static_cast<std::size_t>(asked.rows()));
  for (Index r = 0; r < asked.rows(); ++r) {
    const auto isAlike = [&](const auto& other) { return (asked.row(r) - other).cwiseAbs().maxCoeff() <= rounding; };
    int group = 0;
    if (!isAlike(Eigen::RowVector3d::Zero())) {
      group = 1;
      while (group <= groups && !isAlike(moves.by.row(group - 1))) ++group;
      if (group > kGroups) return std::nullopt;
      if (group > groups) moves.by.row(groups++) = asked.row(r);
    }
    moves.groupOf.push_back(group);
  }
  return moves;
}

SolvedDisplacement MovedSolutions::solve(const ConstrainedSolver& solver, const RowTargets& targets, const Columns3& q,
                                         const std::function<Columns3()>& makeF)
{
  const bool isKnown = wanted_ != nullptr && areSame(wanted_->q, q);
  const bool isSame = isKnown && !answers_.empty() && targets_.reconciled == targets.reconciled;
  const Columns3 asked = isSame ? Columns3(targets.shifts - targets_.shifts) : Columns3();
  const auto moves = isSame ? movesOf(asked, rounding_) : std::nullopt;
  if (!moves || !(moves->by.cwiseAbs().maxCoeff() <= farthest_)) {
    const std::shared_ptr<const Displacement> base = std::exchange(base_, nullptr);
    if (targets_.reconciled != targets.reconciled) answers_.clear();
    const std::shared_ptr<const Wanted> wanted = isKnown ? wanted_ : std::make_shared<const Wanted>(Wanted{q, makeF()});
    Eigen::VectorXd sample = sampled(targets, wanted->f);
    std::optional<Displacement> edited;
    if (isKnown && base != nullptr) edited = solver.solveEdited(*base, targets, wanted->f);
    Displacement found = edited             ? std::move(*edited)
                         : answers_.empty() ? solver.solve(targets, wanted->f)
                                            : solver.solveFrom(nearest(sample), targets, wanted->f);
    wanted_ = wanted;
    targets_ = {targets.shifts, targets.reconciled};
    last_ = std::make_shared<const Displacement>(std::move(found));
    if (answers_.size() == kAnswers) answers_.pop_front();
    answers_.push_back({std::move(sample), last_});
    return {last_, f()};
  }
  if (asked.isZero(0)) {
    last_ = answers_.back().solution;
    return {last_, f()};
  }
  Displacement sum = moves->by.isZero(0) ? *answers_.back().solution : moved(solver, *moves);
  solver.meet(targets, sum.u);  // moves that are no more than rounding as well
  last_ = std::make_shared<const Displacement>(std::move(sum));
  return {last_, f()};
}

Displacement MovedSolutions::moved(const ConstrainedSolver& solver, const Moves& moves)
{
  if (response_.groupOf != moves.groupOf) {
    Columns3 isMoved(targets_.shifts.rows(), 3);
    for (Index r = 0; r < isMoved.rows(); ++r)
      for (int group = 0; group < kGroups; ++group) isMoved(r, group) = moves.groupOf[r] == group + 1;
    response_ = {moves.groupOf,
                 solver.solve({std::move(isMoved), targets_.reconciled}, Columns3::Zero(f()->rows(), 3))};
  }
  const Displacement& reach = response_.reach;
  const Displacement& last = *answers_.back().solution;
  Displacement sum{Columns3(reach.u.rows(), 3), last.corrections, std::max(last.accuracy, reach.accuracy), last.left};
  // The solver may have gone on without multipliers meanwhile.
  if (last.multipliers.rows() == reach.multipliers.rows())
    sum.multipliers = last.multipliers + reach.multipliers * moves.by;
  parallelBlocks(sum.u.rows(), [&](Index i) { sum.u.row(i) = last.u.row(i) + reach.u.row(i) * moves.by; });
  return sum;
}

/// The sum of earlier solutions whose right-hand sides come nearest to `asked`.
Displacement MovedSolutions::nearest(const Eigen::VectorXd& asked) const
{
  Eigen::MatrixXd earlier(asked.size(), answers_.size());
  for (std::size_t k = 0; k < answers_.size(); ++k) earlier.col(k) = answers_[k].asked;
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition;
  decomposition.setThreshold(kDependent);
  const Eigen::VectorXd shares = decomposition.compute(earlier).solve(asked);
  const Displacement& newest = *answers_.back().solution;
  Displacement sum;
  sum.left = newest.left;
  for (Columns3 Displacement::*numbers : {&Displacement::u, &Displacement::multipliers}) {
    Columns3& all = sum.*numbers;
    all.resize((newest.*numbers).rows(), 3);
    parallelBlocks(all.rows(), [&](Index i) {
      Eigen::RowVector3d row = Eigen::RowVector3d::Zero();
      for (std::size_t k = 0; k < answers_.size(); ++k) row += shares[k] * ((*answers_[k].solution).*numbers).row(i);
      all.row(i) = row;
    });
  }
  return sum;
}

}  // namespace holdfast
