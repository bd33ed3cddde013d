#include "holdfast/factor/dense_cholesky.h"

#include <algorithm>

#include <holdfast/factor/dense_kernels_internal.h>
#include <holdfast/numbers/types.h>
#include <holdfast/threads/parallel.h>

namespace holdfast {
namespace {

/// Eliminates the first `count` columns. `endOf(k)` says where the rows end that are not 0 in the columns before k.
template <class EndOf>
bool eliminateColumns(Eigen::MatrixXd& A, Index count, const EndOf& endOf)
{
  // Wide enough for the kernels, narrow enough for all threads to have a share.
  constexpr Index kPanel = 128;
  const DenseKernels& kernels = denseKernels();
  const auto ld = static_cast<int>(A.outerStride());
  for (Index first = 0; first < count; first += kPanel) {
    const auto width = static_cast<int>(std::min(kPanel, count - first));
    const Index next = first + width;
    const Index n = endOf(next);
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

}  // namespace

bool factorizeDense(Eigen::MatrixXd& A)
{
  return eliminateColumns(A, A.rows(), [&](Index /*next*/) { return A.rows(); });
}

/// What elimination leaves of [A, I; I, 0] below A is the inverse, with the other sign.
std::optional<Eigen::MatrixXd> inverseOfDefinite(const Eigen::MatrixXd& A)
{
  const Index n = A.rows();
  Eigen::MatrixXd both = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  both.topLeftCorner(n, n) = A;
  both.bottomLeftCorner(n, n).setIdentity();
  if (!eliminateColumns(both, n, [&](Index next) { return n + next; })) return std::nullopt;
  Eigen::MatrixXd inverse = both.bottomRightCorner(n, n).selfadjointView<Eigen::Lower>();
  inverse *= -1;
  return inverse;
}

}  // namespace holdfast
