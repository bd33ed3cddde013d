#include "holdfast/solve/column_scaling.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace holdfast {

Result<Eigen::VectorXd> unitScale(const Eigen::VectorXd& squares)
{
  Eigen::VectorXd scale = squares.cwiseSqrt().cwiseInverse();
  for (Index k = 0; k < scale.size(); ++k)
    if (!(scale[k] > 0) || !std::isfinite(scale[k]))
      return {{}, fmt::format("unknown {} of {} is in no equation, or in one that is not finite", k, scale.size())};
  return {std::move(scale)};
}

Result<ScaledColumns> scaleColumns(SparseMatrix&& M)
{
  Eigen::VectorXd squares(M.cols());
  parallelBlocks(M.cols(), [&](Index k) { squares[k] = M.col(k).squaredNorm(); });
  Result<Eigen::VectorXd> scale = unitScale(squares);
  if (!scale) return {{}, std::move(scale.failure)};
  parallelBlocks(M.cols(), [&](Index k) {
    for (SparseMatrix::InnerIterator entry(M, k); entry; ++entry) entry.valueRef() *= scale.value[k];
  });
  return {{TwoWayMatrix(std::move(M)), std::move(scale.value)}};
}

}  // namespace holdfast
