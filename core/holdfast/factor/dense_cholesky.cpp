#include "holdfast/factor/dense_cholesky.h"

#include <algorithm>

#include <holdfast/factor/dense_kernels_internal.h>
#include <holdfast/numbers/types.h>
#include <holdfast/threads/parallel.h>

namespace holdfast {

bool factorizeDense(Eigen::MatrixXd& A)
{
  // Wide enough for the kernels, narrow enough for all threads to have a share.
  constexpr Index kPanel = 128;
  const DenseKernels& kernels = denseKernels();
  const auto n = A.rows();
  const auto ld = static_cast<int>(A.outerStride());
  for (Index first = 0; first < n; first += kPanel) {
    const auto width = static_cast<int>(std::min(kPanel, n - first));
    const Index next = first + width;
    if (kernels.cholesky(width, &A(first, first), ld) != 0) return false;
    const Index tiles = (n - next + kPanel - 1) / kPanel;
    const auto heightOf = [&](Index tile) { return static_cast<int>(std::min(kPanel, n - next - tile * kPanel)); };
    parallelFor(tiles, [&](Index tile) {
      kernels.solveRight(heightOf(tile), width, &A(first, first), ld, &A(next + tile * kPanel, first), ld);
    });
    // The first columns are the longest.
    parallelFor(tiles, [&](Index tile) {
      const Index column = next + tile * kPanel;
      const int own = heightOf(tile);
      kernels.symmetricUpdate(own, width, -1, &A(column, first), ld, 1, &A(column, column), ld);
      const Index below = column + own;
      if (below < n)
        kernels.update(static_cast<int>(n - below), own, width, -1, &A(below, first), &A(column, first), ld, 1,
                       &A(below, column), ld);
    });
  }
  return true;
}

}  // namespace holdfast
