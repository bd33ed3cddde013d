#pragma once
/// Sparse matrices of Eigen as CHOLMOD sees them.

#include <type_traits>

#include <cholmod.h>

#include <holdfast/numbers/types.h>

namespace holdfast {

/// The part of a matrix that is stored. The values are CHOLMOD's.
enum class StoredPart : int { All = 0, LowerTriangle = -1 };

/// Returns a view of the compressed `matrix`. The view owns nothing. O(1).
template <class StorageIndex>
[[nodiscard]] cholmod_sparse cholmodView(Eigen::SparseMatrix<double, Eigen::ColMajor, StorageIndex>& matrix,
                                         StoredPart part)
{
  static_assert(std::is_same_v<StorageIndex, int> || std::is_same_v<StorageIndex, SuiteSparse_long>);
  cholmod_sparse view{};
  view.nrow = static_cast<std::size_t>(matrix.rows());
  view.ncol = static_cast<std::size_t>(matrix.cols());
  view.nzmax = static_cast<std::size_t>(matrix.nonZeros());
  view.p = matrix.outerIndexPtr();
  view.i = matrix.innerIndexPtr();
  view.x = matrix.valuePtr();
  view.stype = static_cast<int>(part);
  view.itype = std::is_same_v<StorageIndex, int> ? CHOLMOD_INT : CHOLMOD_LONG;
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  view.sorted = 1;
  view.packed = 1;
  return view;
}

}  // namespace holdfast
