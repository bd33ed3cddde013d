#pragma once
/// `evenlySpread` chooses a few points of many that lie about equally far from one another.

#include <vector>

#include <holdfast/numbers/types.h>

namespace holdfast {

/// Chooses about `target` (larger than 0) of the `points` whose numbers are in `among`. Returns them in that order. No
/// two of them are nearer to one another than some distance. Each point of `among` has a chosen one within that
/// distance. About O(N) for N in `among`.
[[nodiscard]] std::vector<Index> evenlySpread(const Positions& points, const std::vector<Index>& among, Index target);
/// Chooses among all of `points` in the same way. Returns their places, ascending.
[[nodiscard]] std::vector<Index> evenlySpread(const Positions& points, Index target);

}  // namespace holdfast
