#pragma once
/// What rows determine whatever their coefficients are.

#include <vector>

#include <holdfast/elimination/row_components.h>

namespace holdfast {

/// Takes the rows of `order` one by one and gives each one of the unknowns that it names, which no other row has; rows
/// before it may have to change theirs. Returns those that get one, in this order. Any other row depends on rows before
/// it: together they are more than the unknowns that they name. Coefficients at random make no further row depend.
/// Nearly O(terms): what a search in vain has reached is not searched again.
[[nodiscard]] std::vector<Index> matchedRows(const std::vector<RowTerms>& rows, const std::vector<Index>& order,
                                             Index unknownCount);

/// For each unknown, whether independent `rows` leave it free: it is named by fewer rows than there are unknowns, or
/// hangs on one that is so by rows that take it along. The rows that name no free unknown are as many as the other
/// unknowns, and determine them: the coarse decomposition of A. Dulmage, N. Mendelsohn, "Coverings of bipartite
/// graphs", 1958. O(terms) after the matching.
[[nodiscard]] std::vector<bool> freeUnknowns(const std::vector<RowTerms>& rows, Index unknownCount);

}  // namespace holdfast
