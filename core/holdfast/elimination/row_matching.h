#pragma once
/// A matching of rows and unknowns says what rows determine whatever their coefficients are.

#include <vector>

#include <holdfast/elimination/row_components.h>

namespace holdfast {

/// Takes the rows of `order` one by one and gives each an unknown that it names and no other row has. Rows before it
/// may have to change theirs. Returns the rows that get one, in this order. Any other row depends on rows before it:
/// together they are more than the unknowns that they name. With coefficients at random no further row depends. Nearly
/// O(terms): what a search in vain has reached is not searched again.
[[nodiscard]] std::vector<Index> matchedRows(const std::vector<RowTerms>& rows, const std::vector<Index>& order,
                                             Index unknownCount);

/// Tells for each unknown whether independent `rows` leave it free. Unknowns are free where fewer rows name them than
/// they are. An unknown that a row takes along with a free one is free too. The rows that name no free unknown are as
/// many as the other unknowns and determine them. This is the coarse decomposition of A. Dulmage, N. Mendelsohn,
/// "Coverings of bipartite graphs", 1958. O(terms) after the matching.
[[nodiscard]] std::vector<bool> freeUnknowns(const std::vector<RowTerms>& rows, Index unknownCount);

}  // namespace holdfast
