#pragma once
/// The matrix of the normal equations.

#include <holdfast/base/sparse_products.h>

namespace holdfast {

/// The lower triangle of C^T C, each column with ascending rows. O(sum of squares of the row lengths of C).
[[nodiscard]] SparseMatrix gramLower(const TwoWayMatrix& C);

}  // namespace holdfast
