#pragma once
/// The circuits that rows close with a basis of many rows.

#include <vector>

#include <holdfast/elimination/dependency.h>

namespace holdfast {

/// Returns the dependencies of `others` by `basis`, in the order of `others`. The function makes one sparse QR of all
/// rows. Each circuit then takes time by its own size. Its coefficients are followed from row to row as far as they are
/// no rounding of zero.
[[nodiscard]] std::vector<Dependency> circuitsOf(const std::vector<RowTerms>& rows, const std::vector<Index>& basis,
                                                 const std::vector<Index>& others, const std::vector<Index>& unknowns);

}  // namespace holdfast
