#pragma once
/// \file
/// Fewer points where so many would lie upon one another.

#include <vector>

#include <holdfast/base/types.h>

namespace holdfast {

/// Which of `places`, all within a few units of the origin, to draw so that they are `most` (positive) or fewer and
/// spread evenly: the first in each cell of a grid that is as fine as that allows, and never finer than `finest`. Lone
/// places stay. Ascending; all where there are no more than `most`. O(N).
[[nodiscard]] std::vector<Index> thinnedPlaces(const std::vector<Vector3>& places, Index most, double finest);

}  // namespace holdfast
