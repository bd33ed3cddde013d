#pragma once
/// The mean of points: handles rotate about it by default.

#include <cassert>

#include <holdfast/base/types.h>

namespace holdfast {

/// The mean of the rows of `points`, one at least, in model units. Rounds with the size of the coordinates. O(N).
[[nodiscard]] inline Vector3 centroid(const Positions& points)
{
  assert(points.rows() > 0);
  return points.colwise().mean().transpose();
}

}  // namespace holdfast
