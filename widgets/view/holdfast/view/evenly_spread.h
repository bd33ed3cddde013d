#pragma once
/// \file
/// A few points of many that lie about equally far from one another.

#include <vector>

#include <holdfast/base/types.h>

namespace holdfast {

/// The places in `points`, ascending, of about `target` (larger than 0) of them: no two are nearer to one another than
/// some distance, and no point is farther than that from all of them. All, where there are no more than `target`. The
/// same on every run. About O(N).
[[nodiscard]] std::vector<Index> evenlySpread(const Positions& points, Index target);

}  // namespace holdfast
