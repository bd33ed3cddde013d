#pragma once
/// Free parts are what the rows of a large component leave free.

#include <vector>

#include <holdfast/elimination/row_components.h>

namespace holdfast {

/// A free part is a set of unknowns that hang together by rows which do not determine them (`freeUnknowns`). A small
/// part has an orthonormal basis. The basis of a large part would be nearly dense. So the rows of a large part are
/// substituted as far as each has an unknown of its own (`ownUnknowns`). The other rows are kept.
struct FreePart {
  RowComponent component;
  SparseMatrix basis;       ///< component.unknowns x columns
  std::vector<Index> kept;  ///< the rows of the part that the basis does not meet, ascending
  SparseMatrix block;       ///< unknowns x rows, where some are kept
};

/// Returns the parts that independent `rows` leave of the unknowns that they name. All other unknowns have the
/// displacement 0 where the rows ask for 0.
[[nodiscard]] std::vector<FreePart> freeParts(const std::vector<RowTerms>& rows, Index unknownCount);

/// Returns the bases side by side, unknownCount x columns.
[[nodiscard]] SparseMatrix basisOf(const std::vector<FreePart>& parts, Index unknownCount);

/// Returns such bases with no row kept. It makes a sparse QR of each part that keeps rows. O(its entries), which may be
/// as many as the square of the unknowns of a part.
[[nodiscard]] SparseMatrix wholeBasisOf(const std::vector<FreePart>& parts, Index unknownCount);

}  // namespace holdfast
