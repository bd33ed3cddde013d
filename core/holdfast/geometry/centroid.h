#pragma once
/// The mean of points.

#include <cassert>

#include <holdfast/base/types.h>

namespace holdfast {

/// The mean of the rows of `points`, one at least.
[[nodiscard]] inline Vector3 centroid(const Positions& points)
{
  assert(points.rows() > 0);
  return points.colwise().mean().transpose();
}

}  // namespace holdfast
