#pragma once
/// Near pairs are vertices that lie close together.

#include <array>
#include <span>
#include <vector>

#include <holdfast/numbers/types.h>

namespace holdfast {

/// Returns all pairs of `vertices` whose distance is at most `distance` (above 0). The smaller id of a pair comes
/// first, and pairs ascend. Each vertex must be there once, and positions must be finite. O(n log n) where few lie in a
/// ball of that radius. Below what doubles can say of a mesh of that size, only equal positions are pairs.
[[nodiscard]] std::vector<std::array<int, 2>> nearPairs(const Positions& positions, std::span<const int> vertices,
                                                        double distance);

}  // namespace holdfast
