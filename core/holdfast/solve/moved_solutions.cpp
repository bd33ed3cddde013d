#include "holdfast/solve/moved_solutions.h"

#include <algorithm>
#include <limits>
#include <optional>

#include <holdfast/base/parallel.h>

namespace holdfast {
namespace {

constexpr int kGroups = 3;
constexpr double kRoundings = 8;
constexpr double kFar = 4;  // diagonals: larger differences would take digits

/// Rows that have moved by the same vector.
struct Moves {
  std::vector<int> groupOf;  // of each row, from 1 in the order of rows; 0 where it stays
  Eigen::Matrix3d by = Eigen::Matrix3d::Zero();
};

/// Nothing where there are more than `kGroups`. Differences up to `rounding` are none.
std::optional<Moves> movesOf(const Columns3& shifts, double rounding)
{
  Moves moves;
  int groups = 0;
  moves.groupOf.reserve(static_cast<std::size_t>(shifts.rows()));
  for (Index r = 0; r < shifts.rows(); ++r) {
    const auto isAlike = [&](const auto& other) { return (shifts.row(r) - other).cwiseAbs().maxCoeff() <= rounding; };
    int group = 0;
    if (!isAlike(Eigen::RowVector3d::Zero())) {
      group = 1;
      while (group <= groups && !isAlike(moves.by.row(group - 1))) ++group;
      if (group > kGroups) return std::nullopt;
      if (group > groups) moves.by.row(groups++) = shifts.row(r);
    }
    moves.groupOf.push_back(group);
  }
  return moves;
}

}  // namespace

MovedSolutions::MovedSolutions(const SolverMesh& mesh)
    : rounding_(kRoundings * std::numeric_limits<double>::epsilon() * mesh.rest.cwiseAbs().maxCoeff()),
      farthest_(kFar * mesh.diagonal)
{
}

const Displacement& MovedSolutions::solve(const ConstrainedSolver& solver, const RowTargets& targets, const Columns3& q,
                                          const std::function<Columns3()>& makeF)
{
  const bool isSame = q_.rows() == q.rows() && q_ == q && targets_.reconciled == targets.reconciled;
  const auto moves = isSame ? movesOf(targets.shifts - targets_.shifts, rounding_) : std::nullopt;
  if (!moves || !(moves->by.cwiseAbs().maxCoeff() <= farthest_)) {
    q_ = q;
    f_ = makeF();
    targets_ = {targets.shifts, targets.reconciled};
    solution_ = solver.solve(targets, f_);
    return solution_;
  }
  if (moves->by.isZero(0)) return solution_;
  if (response_.groupOf != moves->groupOf) {
    Columns3 isMoved(targets.shifts.rows(), 3);
    for (Index r = 0; r < isMoved.rows(); ++r)
      for (int group = 0; group < kGroups; ++group) isMoved(r, group) = moves->groupOf[r] == group + 1;
    response_ = {moves->groupOf, solver.solve({std::move(isMoved), targets.reconciled}, Columns3::Zero(f_.rows(), 3))};
  }
  const Displacement& reach = response_.reach;
  sum_.u.resize(reach.u.rows(), 3);
  sum_.corrections = solution_.corrections;
  sum_.accuracy = std::max(solution_.accuracy, reach.accuracy);
  parallelBlocks(sum_.u.rows(), [&](Index i) { sum_.u.row(i) = solution_.u.row(i) + reach.u.row(i) * moves->by; });
  solver.meet(targets, sum_.u);
  return sum_;
}

}  // namespace holdfast
