#pragma once
/// Columns of unit length: the normal equations get a unit diagonal, nearly.

#include <holdfast/base/result.h>
#include <holdfast/base/sparse_products.h>

namespace holdfast {

/// C = M diag(scale) with columns of length 1.
struct ScaledColumns {
  TwoWayMatrix C;
  Eigen::VectorXd scale;
};

/// Takes the memory of `M`. Fails for an empty or non-finite column. O(entries).
[[nodiscard]] Result<ScaledColumns> scaleColumns(SparseMatrix&& M);

/// By which columns with these sums of squares get length 1. Fails as `scaleColumns`.
[[nodiscard]] Result<Eigen::VectorXd> unitScale(const Eigen::VectorXd& squares);

}  // namespace holdfast
