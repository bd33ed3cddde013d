#include "holdfast/solve/column_scaling.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace holdfast {

Result<ScaledColumns> scaleColumns(SparseMatrix M)
{
  ScaledColumns result;
  result.scale.resize(M.cols());
  for (Index k = 0; k < M.cols(); ++k) {
    const double length = M.col(k).norm();
    if (!(length > 0) || !std::isfinite(length))
      return {{}, fmt::format("unknown {} of {} is in no equation, or in one that is not finite", k, M.cols())};
    result.scale[k] = 1 / length;
    M.col(k) *= result.scale[k];
  }
  result.C = TwoWayMatrix(std::move(M));
  return {std::move(result)};
}

}  // namespace holdfast
