#pragma once
/// Sparse QR with a fill-reducing order, for components of constraints too large for a dense block, and for the
/// least-squares factor of last resort. SPQR where it is built, Eigen's otherwise; both give the same things.

#include <vector>

#include <holdfast/base/types.h>

namespace holdfast {

/// An orthogonal matrix as a product of reflections, m x m: Q = P^T H_1 H_2 ... H_k with H_j = I - tau_j h_j h_j^T and
/// (P x)_place(i) = x_i. It takes far less memory than its entries.
struct Reflections {
  SparseMatrix h;            ///< m x k
  Eigen::VectorXd tau;       ///< k
  std::vector<Index> place;  ///< m

  /// Q x. O(entries of h).
  [[nodiscard]] Columns3 times(Columns3 x) const;
  /// Q^T x. O(entries of h).
  [[nodiscard]] Columns3 transposeTimes(const Columns3& x) const;
  /// Columns of Q from `first` on. O(their entries), which may be as many as m^2.
  [[nodiscard]] SparseMatrix columnsFrom(Index first) const;
};

/// M = Q R P^T with P the permutation of columns and R upper trapezoidal.
struct SparseQrResult {
  Index rank = 0;
  SparseMatrix R;              ///< rank x columns; its first `rank` columns are upper triangular and regular
  std::vector<Index> columns;  ///< column k of R belongs to column columns[k] of M; the dependent ones come last
  Reflections Q;               ///< empty unless asked for

  /// z of M^T M z = g, the semi-normal equations; M has full column rank.
  [[nodiscard]] Columns3 solveSeminormal(const Columns3& g) const;
};

enum class WantQ { No, Yes };

/// The order in which columns are eliminated.
enum class ColumnOrder { FillReducing, AsGiven };

/// Scales every column of `M` (none is zero) to unit length, so that one tolerance fits all; returns the lengths.
[[nodiscard]] Eigen::VectorXd normalizeColumns(SparseMatrix& M);

/// Columns whose remainder is `tolerance` or shorter are dependent; a negative tolerance accepts all.
[[nodiscard]] SparseQrResult sparseQr(const SparseMatrix& M, double tolerance, WantQ wantQ,
                                      ColumnOrder order = ColumnOrder::FillReducing);

/// The two behind it; the first is declared always and defined only where SuiteSparse is built.
[[nodiscard]] SparseQrResult sparseQrSuiteSparse(const SparseMatrix& M, double tolerance, WantQ wantQ,
                                                 ColumnOrder order = ColumnOrder::FillReducing);
[[nodiscard]] SparseQrResult sparseQrEigen(const SparseMatrix& M, double tolerance, WantQ wantQ,
                                           ColumnOrder order = ColumnOrder::FillReducing);

}  // namespace holdfast
