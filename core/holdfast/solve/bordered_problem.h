#pragma once
/// The problem that constraints leave, and the same for a few rows more or fewer on the factor that is there.

#include <memory>

#include <holdfast/elimination/diagnosis.h>
#include <holdfast/solve/corrected_solve.h>
#include <holdfast/solve/reduced_matrix.h>

namespace holdfast {

/// The factor of a problem, its base, and what a border adds to that.
class BorderedFactor : public LeastSquaresFactor {
 public:
  /// The rows that the border adds, by their places in the list.
  [[nodiscard]] virtual const std::vector<Index>& added() const = 0;

  /// What makes of a solution of the base one of the bordered problem, but for the share that the factor leaves of an
  /// error: z, and the differences of multipliers below it. `u` (n x 3) solves the base for the same f, and `missed`
  /// (rows x 3) is what it leaves of B u = d. O(half of the factor).
  [[nodiscard]] virtual Columns3 stepFromBase(const Columns3& u, const Columns3& f, const Columns3& missed) const = 0;
};

/// Minimise |C z - f|, with u = Q2 diag(scale) z.
struct ReducedProblem {
  std::shared_ptr<const ReducedMatrix> C;  ///< of Q2 diag(scale): columns of length 1, and kept rows of length 1 below
  Eigen::VectorXd scale;
  Index kept = 0;  ///< how many rows are kept
  std::shared_ptr<const LeastSquaresFactor> factor;
  std::shared_ptr<const BorderedFactor> border;  ///< the same, of a problem that is bordered
};

/// What rows below the equations are.
enum class RowsBelow {
  Kept,      ///< they hold exactly; none, or those of our own factorisation
  Equations  ///< as those of A
};

/// That of min |A Q2 y - f| with K y below it; there may be no K. `rest` (n x 3) is a typical solution to measure
/// factors on.
[[nodiscard]] Result<ReducedProblem> makeReducedProblem(std::shared_ptr<const EnergyMatrix> A, SparseMatrix Q2,
                                                        SparseRows K, RowsBelow below, Columns3 rest, Backend backend,
                                                        EliminationOrder order);

/// More rows take longer than another factorisation does.
inline constexpr std::size_t kMostEdited = 300;

/// `base`, which was made under the rows `before`, under the rows `now`. A row fewer is a column more: the displacement
/// by which that row alone changes. A row more is kept, with a multiplier. With these borders W the system is solved by
/// our own factor of `base`, N, and the Schur complement S_0 - W^T N^-1 W. Fails where the factor is another one, where
/// more than `kMostEdited` rows differ, where other parts are held, and where the complement is singular in doubles.
[[nodiscard]] Result<ReducedProblem> bordered(const std::shared_ptr<const ReducedProblem>& base,
                                              const EliminatedConstraints& before, const EliminatedConstraints& now);

}  // namespace holdfast
