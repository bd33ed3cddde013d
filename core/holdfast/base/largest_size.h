#pragma once
/// The sizes of the entries of matrices with many rows, over all cores.

#include <cmath>
#include <numeric>
#include <vector>

#include <holdfast/base/parallel.h>

namespace holdfast {

/// The largest of |scale_i x_ij|: 0 without rows, NaN where an entry is none.
template <class Matrix>
[[nodiscard]] double largestSize(const Eigen::VectorXd& scale, const Eigen::MatrixBase<Matrix>& x)
{
  constexpr Index kBlock = 4096;
  const auto larger = [](double a, double b) { return b > a || std::isnan(b) ? b : a; };
  std::vector<double> ofBlocks(static_cast<std::size_t>((x.rows() + kBlock - 1) / kBlock));
  parallelFor(static_cast<Index>(ofBlocks.size()), [&](Index block) {
    for (Index i = block * kBlock; i < std::min(x.rows(), (block + 1) * kBlock); ++i)
      for (Index j = 0; j < x.cols(); ++j) {
        const double size = std::abs(x(i, j));
        ofBlocks[block] = larger(ofBlocks[block], scale.size() == 0 ? size : std::abs(scale[i]) * size);
      }
  });
  return std::accumulate(ofBlocks.begin(), ofBlocks.end(), 0.0, larger);
}

/// The largest of |x_ij|.
template <class Matrix>
[[nodiscard]] double largestSize(const Eigen::MatrixBase<Matrix>& x)
{
  return largestSize({}, x);
}

}  // namespace holdfast
