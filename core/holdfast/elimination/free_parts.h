#pragma once
/// What the rows of a large component leave free.

#include <vector>

#include <holdfast/elimination/row_components.h>

namespace holdfast {

/// Unknowns that hang together by rows which do not determine them (`freeUnknowns`). Small parts have an orthonormal
/// basis. That of a large one would be nearly dense: its rows are substituted as far as each has an unknown of its own
/// (`ownUnknowns`), and the rest of them are kept.
struct FreePart {
  RowComponent component;
  SparseMatrix basis;       ///< component.unknowns x columns
  std::vector<Index> kept;  ///< those of its rows that the basis does not meet, ascending
  SparseMatrix block;       ///< unknowns x rows, where some are kept
};

/// The parts that independent `rows` leave of the unknowns that they name. The displacement of all others is 0 where
/// the rows ask for 0.
[[nodiscard]] std::vector<FreePart> freeParts(const std::vector<RowTerms>& rows, Index unknownCount);

/// The bases side by side, unknownCount x columns.
[[nodiscard]] SparseMatrix basisOf(const std::vector<FreePart>& parts, Index unknownCount);

/// The same with no row kept, by a sparse QR of each part that keeps some. O(its entries), which may be as many as the
/// square of the unknowns of a part.
[[nodiscard]] SparseMatrix wholeBasisOf(const std::vector<FreePart>& parts, Index unknownCount);

}  // namespace holdfast
