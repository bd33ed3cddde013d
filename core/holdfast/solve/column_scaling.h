#pragma once
/// Columns of unit length: the normal equations get a unit diagonal.

#include <holdfast/base/result.h>
#include <holdfast/base/sparse_products.h>

namespace holdfast {

/// C = M diag(scale) with columns of length 1.
struct ScaledColumns {
  TwoWayMatrix C;
  Eigen::VectorXd scale;
};

/// Fails for an empty or non-finite column.
[[nodiscard]] Result<ScaledColumns> scaleColumns(SparseMatrix M);

}  // namespace holdfast
