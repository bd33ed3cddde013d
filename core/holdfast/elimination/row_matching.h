#pragma once
/// Which rows depend on others whatever their coefficients are.

#include <vector>

#include <holdfast/elimination/row_components.h>

namespace holdfast {

/// Takes the rows of `order` one by one and gives each one of the unknowns that it names, which no other row has; rows
/// before it may have to change theirs. Returns those that get one, in this order. Any other row depends on rows before
/// it: together they are more than the unknowns that they name. Coefficients at random make no further row depend.
/// Nearly O(terms): what a search in vain has reached is not searched again.
[[nodiscard]] std::vector<Index> matchedRows(const std::vector<RowTerms>& rows, const std::vector<Index>& order,
                                             Index unknownCount);

}  // namespace holdfast
