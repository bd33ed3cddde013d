#pragma once
/// Vertices that lie close together.

#include <array>
#include <span>
#include <vector>

#include <holdfast/base/types.h>

namespace holdfast {

/// All pairs of `vertices`, each of which is there once, whose distance is at most `distance` (above 0), the smaller id
/// first, ascending. Positions are finite. O(n log n) where few lie in a ball of that radius; pairs closer than their
/// doubles can say of a mesh of that size are none but for equal positions.
[[nodiscard]] std::vector<std::array<int, 2>> nearPairs(const Positions& positions, std::span<const int> vertices,
                                                        double distance);

}  // namespace holdfast
