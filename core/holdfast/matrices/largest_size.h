#pragma once
/// The sizes of the entries of matrices with many rows, over all cores.

#include <algorithm>

#include <holdfast/threads/parallel.h>

namespace holdfast {

/// Returns the largest of `ofRows(first, count)` over blocks of rows, and NaN where one is NaN. None may be negative.
template <class OfRows>
[[nodiscard]] double largestOfBlocks(Index rows, const OfRows& ofRows)
{
  constexpr Index kBlock = 4096;
  Eigen::VectorXd ofBlocks = Eigen::VectorXd::Zero((rows + kBlock - 1) / kBlock + 1);
  parallelFor(ofBlocks.size() - 1,
              [&](Index block) { ofBlocks[block] = ofRows(block * kBlock, std::min(kBlock, rows - block * kBlock)); });
  return ofBlocks.maxCoeff<Eigen::PropagateNaN>();
}

/// Returns the largest of |x_ij|: 0 without rows, and NaN where an entry is NaN.
template <class Matrix>
[[nodiscard]] double largestSize(const Eigen::MatrixBase<Matrix>& x)
{
  return largestOfBlocks(x.rows(), [&](Index first, Index count) {
    return x.middleRows(first, count).cwiseAbs().template maxCoeff<Eigen::PropagateNaN>();
  });
}

/// Returns the largest of |scale_i x_ij|.
template <class Matrix>
[[nodiscard]] double largestSize(const Eigen::VectorXd& scale, const Eigen::MatrixBase<Matrix>& x)
{
  return largestOfBlocks(x.rows(), [&](Index first, Index count) {
    return (scale.segment(first, count).asDiagonal() * x.middleRows(first, count))
        .cwiseAbs()
        .template maxCoeff<Eigen::PropagateNaN>();
  });
}

}  // namespace holdfast
