#pragma once
/// A few points of many that lie about equally far from one another.

#include <vector>

#include <holdfast/base/types.h>

namespace holdfast {

/// About `target` (larger than 0) of the `points` at `among`, in that order: no two are nearer to one another than some
/// distance, and none of `among` is farther than that from all of them. About O(N) for N in `among`.
[[nodiscard]] std::vector<Index> evenlySpread(const Positions& points, const std::vector<Index>& among, Index target);
/// The same of all of `points`: their places, ascending.
[[nodiscard]] std::vector<Index> evenlySpread(const Positions& points, Index target);

}  // namespace holdfast
