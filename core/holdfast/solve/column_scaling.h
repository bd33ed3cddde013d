#pragma once
/// Columns of unit length: the normal equations get a unit diagonal, nearly.

#include <holdfast/base/result.h>
#include <holdfast/base/sparse_products.h>

namespace holdfast {

/// C = M diag(scale) with columns of length 1; below it rows of length 1 that hold exactly.
struct ScaledColumns {
  TwoWayMatrix C;
  Eigen::VectorXd scale;
  Index kept = 0;  ///< how many rows hold exactly: see `LeastSquaresFactor`
};

/// Takes the memory of `M`. Fails for an empty or non-finite column. The rows `K` hold exactly. O(entries).
[[nodiscard]] Result<ScaledColumns> scaleColumns(SparseMatrix&& M, const SparseMatrix& K = {});

}  // namespace holdfast
