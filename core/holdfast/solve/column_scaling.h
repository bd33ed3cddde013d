#pragma once
/// Columns of unit length. With them the normal equations have a unit diagonal, nearly.

#include <holdfast/matrices/sparse_products.h>
#include <holdfast/words/result.h>

namespace holdfast {

/// C = M diag(scale) with columns of length 1.
struct ScaledColumns {
  TwoWayMatrix C;
  Eigen::VectorXd scale;
};

/// Scales the columns of `M` and takes its memory. Fails for an empty or non-finite column. O(entries).
[[nodiscard]] Result<ScaledColumns> scaleColumns(SparseMatrix&& M);

/// Returns the factors that give length 1 to columns with these sums of squares. Fails as `scaleColumns` does.
[[nodiscard]] Result<Eigen::VectorXd> unitScale(const Eigen::VectorXd& squares);

}  // namespace holdfast
