#pragma once
/// \file
/// Sparse matrices of random numbers.

#include <holdfast/numbers/types.h>

#include "support/random.h"

namespace holdfast::test {

/// Two entries a column in the mean, some columns without any.
[[nodiscard]] inline SparseMatrix randomSparse(Random& random, Index rows, Index columns)
{
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(rows, columns);
  for (Index k = 0; k < 2 * columns; ++k)
    dense(random.integer(0, rows - 1), random.integer(0, columns - 1)) = random.uniform(-1, 1);
  return dense.sparseView(1, 0);
}

}  // namespace holdfast::test
