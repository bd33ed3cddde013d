#pragma once
/// Columns of unit length: the normal equations get a unit diagonal.

#include <memory>

#include <holdfast/base/result.h>
#include <holdfast/base/types.h>

namespace holdfast {

/// C = M diag(scale) with columns of length 1.
struct ScaledColumns {
  std::shared_ptr<const SparseMatrix> C;
  Eigen::VectorXd scale;
};

/// Fails for an empty or non-finite column.
[[nodiscard]] Result<ScaledColumns> scaleColumns(SparseMatrix M);

}  // namespace holdfast
