#pragma once
/// Right-hand sides and solutions as `PackedFactor` takes them: rows of four numbers, in the order of elimination.

#include <algorithm>
#include <vector>

#include <holdfast/threads/parallel.h>

namespace holdfast {

/// Puts the rows of `b` into `x`, in the order of `rows`: row `rows[0]` first, and so on. O(rows).
inline void gather(const std::vector<int>& rows, const Columns3& b, std::vector<double>& x)
{
  x.resize(4 * rows.size());
  parallelBlocks(static_cast<Index>(rows.size()), [&](Index k) { std::ranges::copy(b.row(rows[k]), &x[4 * k]); });
}

/// Puts the rows of `x` back into the rows `rows` of `z`. Other rows of `z` stay as they are.
inline void scatter(const std::vector<int>& rows, const std::vector<double>& x, Columns3& z)
{
  parallelBlocks(static_cast<Index>(rows.size()),
                 [&](Index k) { z.row(rows[k]) = Eigen::Map<const Eigen::RowVector3d>(&x[4 * k]); });
}

}  // namespace holdfast
