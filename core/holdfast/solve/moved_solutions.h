#pragma once
/// Solutions of a drag. The displacement is linear in what the rows ask for. Often few groups of rows have moved since
/// another solution, each as a whole. Then the difference is a sum of stored columns.
///
/// Where rotations change, this begins from the sum of earlier solutions whose f is nearest. One more solve corrects
/// that, as is done for successive right-hand sides (Fischer, 1998).

#include <deque>
#include <functional>
#include <memory>
#include <optional>

#include <holdfast/mesh/solver_mesh.h>
#include <holdfast/solve/constrained_solver.h>

namespace holdfast {

/// A displacement, and the f that A u is near to.
struct SolvedDisplacement {
  std::shared_ptr<const Displacement> displacement;
  std::shared_ptr<const Columns3> f;
};

/// The solutions of one solver, which is the same at every call.
class MovedSolutions {
 public:
  explicit MovedSolutions(const SolverMesh& mesh);

  /// Begins the solutions of a solver that was `edited` from that of `base`. The first solution is made of the last one
  /// of `base`, where it can be.
  MovedSolutions(const SolverMesh& mesh, const MovedSolutions& base);

  /// Solves as `solver.solve(targets, makeF())`. `q` (n x 3) is all that `makeF` depends on. A drag that rotates
  /// nothing costs O(n) from its third solution on. Last digits depend on the solutions before.
  [[nodiscard]] SolvedDisplacement solve(const ConstrainedSolver& solver, const RowTargets& targets, const Columns3& q,
                                         const std::function<Columns3()>& makeF);

 private:
  /// What a solution was made of.
  struct Wanted {
    Columns3 q;
    Columns3 f;
  };

  /// Rows that have moved by the same vector since the last solution that was solved for.
  struct Moves {
    std::vector<int> groupOf;  // of each row, from 1 in the order of rows; 0 where it stays
    Eigen::Matrix3d by = Eigen::Matrix3d::Zero();
  };

  /// How far the displacement reaches, n x 3, when the rows of groups 1, 2 and 3 move by 1: a column for each group.
  struct Response {
    std::vector<int> groupOf;  // of each row; 0 where it stays
    Displacement reach;
  };

  /// What was asked for, in places, and what that led to.
  struct Answer {
    Eigen::VectorXd asked;
    std::shared_ptr<const Displacement> solution;
  };

  [[nodiscard]] std::shared_ptr<const Columns3> f() const { return {wanted_, &wanted_->f}; }
  /// Returns the groups of rows that move, and none where there are more than three. Differences up to `rounding` count
  /// as none. `ConstrainedSolver::meet` meets what they ask for.
  [[nodiscard]] static std::optional<Moves> movesOf(const Columns3& asked, double rounding);
  /// Returns the last solution that was solved for, plus what the moves add to it.
  [[nodiscard]] Displacement moved(const ConstrainedSolver& solver, const Moves& moves);
  [[nodiscard]] Displacement nearest(const Eigen::VectorXd& asked) const;

  double rounding_ = 0;  // of shifts, model units
  double farthest_ = 0;  // how far rows move from a solution until there is another one

  std::shared_ptr<const Wanted> wanted_;  // of the last solution that was solved for
  RowTargets targets_;                    // those of that solution
  std::deque<Answer> answers_;            // the ones solved for lately, the newest last
  Response response_;
  std::shared_ptr<const Displacement> last_;
  std::shared_ptr<const Displacement> base_;  // the first solution begins from it
};

}  // namespace holdfast
