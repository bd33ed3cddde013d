#pragma once
/// Right sides and solutions as `PackedFactor` takes them: rows of four numbers, in the order of elimination.

#include <algorithm>
#include <vector>

#include <holdfast/base/parallel.h>

namespace holdfast {

/// Puts the rows of `b` into `x`: first that of the number `rows[0]`, and so on. O(rows).
inline void gather(const std::vector<int>& rows, const Columns3& b, std::vector<double>& x)
{
  x.resize(4 * rows.size());
  parallelBlocks(static_cast<Index>(rows.size()), [&](Index k) { std::ranges::copy(b.row(rows[k]), &x[4 * k]); });
}

/// The inverse. Other rows of `z` stay as they are.
inline void scatter(const std::vector<int>& rows, const std::vector<double>& x, Columns3& z)
{
  parallelBlocks(static_cast<Index>(rows.size()),
                 [&](Index k) { z.row(rows[k]) = Eigen::Map<const Eigen::RowVector3d>(&x[4 * k]); });
}

}  // namespace holdfast
