#pragma once
/// Sparse QR with a fill-reducing order, for components of constraints too large for a dense block, and for the
/// least-squares factor of last resort. SPQR where it is built, Eigen's otherwise; both give the same things.

#include <vector>

#include <holdfast/base/types.h>

namespace holdfast {

/// M = Q R P^T with P the permutation of columns and R upper trapezoidal.
struct SparseQrResult {
  Index rank = 0;
  SparseMatrix R;              ///< rank x columns; its first `rank` columns are upper triangular and regular
  std::vector<Index> columns;  ///< column k of R belongs to column columns[k] of M; the dependent ones come last
  SparseMatrix Q;              ///< rows x rows, orthonormal; empty unless asked for
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
