#pragma once
/// The circuits that rows close with a basis of many rows.

#include <vector>

#include <holdfast/elimination/dependency.h>

namespace holdfast {

/// The dependencies of `others` by `basis`, in the order of `others`. Each circuit takes time by its own size: its
/// coefficients are followed from row to row as far as they are no rounding of zero. One sparse QR of all rows.
[[nodiscard]] std::vector<Dependency> circuitsOf(const std::vector<RowTerms>& rows, const std::vector<Index>& basis,
                                                 const std::vector<Index>& others, const std::vector<Index>& unknowns);

}  // namespace holdfast
