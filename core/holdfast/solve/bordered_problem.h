#pragma once
/// The problem that constraints leave. The factor that is there also serves the same problem with a few rows more or
/// fewer.

#include <memory>

#include <holdfast/elimination/diagnosis.h>
#include <holdfast/solve/corrected_solve.h>
#include <holdfast/solve/reduced_matrix.h>

namespace holdfast {

/// A bordered factor takes the factor of a problem, its base, and adds a border.
class BorderedFactor : public LeastSquaresFactor {
 public:
  /// Returns the rows that the border adds, by their places in the list.
  [[nodiscard]] virtual const std::vector<Index>& added() const = 0;

  /// Returns the step from a solution of the base to one of the bordered problem: z, and below it the differences of
  /// multipliers. It is exact but for the share of an error that the factor leaves. `u` (n x 3) solves the base for the
  /// same f. `missed` (rows x 3) is what `u` leaves of B u = d. O(half of the factor).
  [[nodiscard]] virtual Columns3 stepFromBase(const Columns3& u, const Columns3& f, const Columns3& missed) const = 0;
};

/// The problem is to minimise |C z - f|, with u = Q2 diag(scale) z.
struct ReducedProblem {
  std::shared_ptr<const ReducedMatrix> C;  ///< with Q2 diag(scale): columns of length 1; kept rows of length 1 below
  Eigen::VectorXd scale;
  Index kept = 0;  ///< how many rows are kept
  std::shared_ptr<const LeastSquaresFactor> factor;
  std::shared_ptr<const BorderedFactor> border;  ///< the same factor where the problem is bordered
};

/// Rows below the equations have one of these meanings.
enum class RowsBelow {
  Kept,      ///< they hold exactly; there are none, or our own factorisation takes them
  Equations  ///< they are equations like the rows of A
};

/// Makes the problem min |A Q2 y - f| with K y below it. There may be no K. `rest` (n x 3) is a typical solution, by
/// which factors are measured.
[[nodiscard]] Result<ReducedProblem> makeReducedProblem(std::shared_ptr<const EnergyMatrix> A, SparseMatrix Q2,
                                                        SparseRows K, RowsBelow below, Columns3 rest, Backend backend,
                                                        EliminationOrder order);

/// A border of more rows than this takes longer than another factorisation.
inline constexpr std::size_t kMostEdited = 300;

/// Makes the problem under the rows `now` from `base`, which was made under the rows `before`. Each row fewer is a
/// column more: the displacement by which that row alone changes. Each row more is kept, with a multiplier. Our own
/// factor N of `base` and the borders W solve the system, by the Schur complement S_0 - W^T N^-1 W.
///
/// Fails where the factor is not our own, where more than `kMostEdited` rows differ, and where other parts are held.
/// Fails too where the complement is singular in doubles.
[[nodiscard]] Result<ReducedProblem> bordered(const std::shared_ptr<const ReducedProblem>& base,
                                              const EliminatedConstraints& before, const EliminatedConstraints& now);

}  // namespace holdfast
