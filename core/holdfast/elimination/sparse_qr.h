#pragma once
/// Sparse QR with a fill-reducing order. It serves components of constraints that are too large for a dense block, and
/// the least-squares factor of last resort. SPQR does it where that is built, else Eigen; both give the same things.

#include <vector>

#include <holdfast/numbers/types.h>

namespace holdfast {

/// An orthogonal matrix as a product of reflections, m x m. It is Q = P^T H_1 H_2 ... H_k with H_j = I - tau_j h_j
/// h_j^T and (P x)_place(i) = x_i. It takes far less memory than its entries.
struct Reflections {
  SparseMatrix h;            ///< m x k
  Eigen::VectorXd tau;       ///< k
  std::vector<Index> place;  ///< m

  /// Returns Q x. O(entries of h).
  [[nodiscard]] Columns3 times(Columns3 x) const;
  /// Returns Q^T x. O(entries of h).
  [[nodiscard]] Columns3 transposeTimes(const Columns3& x) const;
  /// Returns the columns of Q from `first` on. O(their entries), which may be as many as m^2.
  [[nodiscard]] SparseMatrix columnsFrom(Index first) const;
};

/// M = Q R P^T with P the permutation of columns and R upper trapezoidal.
struct SparseQrResult {
  Index rank = 0;
  SparseMatrix R;              ///< rank x columns; its first `rank` columns are upper triangular and regular
  std::vector<Index> columns;  ///< column k of R belongs to column columns[k] of M; the dependent ones come last
  Reflections Q;               ///< empty unless asked for

  /// Returns z of M^T M z = g, by the semi-normal equations. M must have full column rank.
  [[nodiscard]] Columns3 solveSeminormal(const Columns3& g) const;
};

enum class WantQ { No, Yes };

/// The order in which columns are eliminated.
enum class ColumnOrder { FillReducing, AsGiven };

/// Scales every column of `M` to unit length, so that one tolerance fits all. No column may be zero. Returns the
/// lengths.
[[nodiscard]] Eigen::VectorXd normalizeColumns(SparseMatrix& M);

/// Factorises `M`. Columns whose remainder is `tolerance` or shorter are dependent. A negative tolerance accepts all.
[[nodiscard]] SparseQrResult sparseQr(const SparseMatrix& M, double tolerance, WantQ wantQ,
                                      ColumnOrder order = ColumnOrder::FillReducing);

/// These two do the work. The first is always declared, but defined only where SuiteSparse is built.
[[nodiscard]] SparseQrResult sparseQrSuiteSparse(const SparseMatrix& M, double tolerance, WantQ wantQ,
                                                 ColumnOrder order = ColumnOrder::FillReducing);
[[nodiscard]] SparseQrResult sparseQrEigen(const SparseMatrix& M, double tolerance, WantQ wantQ,
                                           ColumnOrder order = ColumnOrder::FillReducing);

}  // namespace holdfast
