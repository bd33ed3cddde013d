#pragma once
/// \file
/// One polygon cut into triangles.

#include <array>
#include <vector>

#include <holdfast/base/types.h>

namespace holdfast {

/// The n - 2 triangles of a polygon, as numbers of its corners. No coordinate is beyond 1. Of the ears that can be cut
/// off, the best shaped goes first, of equals the one at the first corner. O(n log n) where ears hold few corners of
/// others, as in polygons that do not wind about themselves.
[[nodiscard]] std::vector<std::array<Index, 3>> clipEars(std::vector<Vector3> polygon);

}  // namespace holdfast
