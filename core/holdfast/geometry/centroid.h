#pragma once
/// \file
/// The mean of points: what handles turn about where nothing else is said.

#include <holdfast/base/types.h>

namespace holdfast {

/// The mean of the rows of `points`, one at least, in model units. Rounds with the size of the coordinates. O(N).
[[nodiscard]] Vector3 centroid(const Positions& points);

}  // namespace holdfast
