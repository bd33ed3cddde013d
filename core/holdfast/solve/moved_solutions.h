#pragma once
/// Solutions of a drag. The displacement is linear in what the rows ask for: where few groups of rows have moved, each
/// as a whole, since another solution, the difference is a sum of stored columns. Where rotations change, the sum of
/// earlier solutions whose f is nearest is corrected by one more, as successive right-hand sides are (Fischer, 1998).

#include <deque>
#include <functional>
#include <memory>

#include <holdfast/mesh/solver_mesh.h>
#include <holdfast/solve/constrained_solver.h>

namespace holdfast {

/// For one solver, which is the same at every call.
class MovedSolutions {
 public:
  explicit MovedSolutions(const SolverMesh& mesh);

  /// For a solver that was `edited` from that of `base`: the first solution is made of the last one of that, which is
  /// not to change until then, where it can be.
  MovedSolutions(const SolverMesh& mesh, const MovedSolutions& base);

  /// As `solver.solve(targets, makeF())`; `q` (n x 3) is all that `makeF` depends on. O(n) from the third solution of a
  /// drag on where it rotates nothing. Last digits depend on the solutions before. Valid until the next call.
  [[nodiscard]] const Displacement& solve(const ConstrainedSolver& solver, const RowTargets& targets, const Columns3& q,
                                          const std::function<Columns3()>& makeF);

  /// The f of the last solution.
  [[nodiscard]] const Columns3& f() const noexcept { return wanted_->f; }

 private:
  /// What a solution was made of.
  struct Wanted {
    Columns3 q;
    Columns3 f;
  };

  /// How far it reaches, n x 3, when the rows of groups 1, 2 and 3 move by 1: a column for each.
  struct Response {
    std::vector<int> groupOf;  // of each row; 0 where it stays
    Displacement reach;
  };

  /// What was asked for, in places, and what that led to.
  struct Answer {
    Eigen::VectorXd asked;
    Displacement solution;
  };

  /// None before the first one.
  [[nodiscard]] const Displacement* last() const;
  [[nodiscard]] Displacement nearest(const Eigen::VectorXd& asked) const;

  double rounding_ = 0;  // of shifts, model units
  double farthest_ = 0;  // that rows move from a solution until there is another one

  std::shared_ptr<const Wanted> wanted_;  // of the last solution that was solved for
  RowTargets targets_;                    // its own
  std::deque<Answer> answers_;            // solved for lately, the last one last
  Response response_;
  Displacement sum_;
  bool isSum_ = false;                  // the last solution is `sum_`, not that of the last answer
  const Displacement* base_ = nullptr;  // from which the first solution begins
};

}  // namespace holdfast
