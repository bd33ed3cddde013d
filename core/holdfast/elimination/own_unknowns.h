#pragma once
/// Rows that have an unknown of their own. Each is solved for this unknown without arithmetic on other rows.

#include <vector>

#include <holdfast/elimination/row_components.h>

namespace holdfast {

struct OwnUnknown {
  Index row = 0;
  Index unknown = 0;
};

/// Returns a list of some of `rows`, each with an own unknown. Neither the rows behind it in this list name that
/// unknown, nor do the rows outside the list. No row outside depends on rows of the list. No row of the list depends on
/// any other row. Moves of own unknowns alone meet such a row with 1 and all others of `rows` with 0. A row is in the
/// list only if these moves are at most `kMostMoved` in all. O(terms).
///
/// Points at random in up to 0.8 faces for each vertex leave few rows outside.
[[nodiscard]] std::vector<OwnUnknown> ownUnknowns(const std::vector<RowTerms>& rows, Index unknownCount);

/// This bounds the sensitivities of rows with own unknowns. It is far below the inverse of the rank tolerance.
inline constexpr double kMostMoved = 100;

/// Displacements that rows of a list map to zero.
struct SubstitutedRows {
  SparseMatrix basis;       ///< unknowns x free ones: 1 at free unknowns, and how own unknowns follow them
  std::vector<Index> kept;  ///< rows that are not substituted and that the basis does not meet, ascending
};

/// Substitutes own unknowns by the others of their rows, where no coefficient exceeds `kLargestShare`. O(entries).
[[nodiscard]] SubstitutedRows substituted(const std::vector<RowTerms>& rows, Index unknownCount);

/// The basis is not orthogonal, and larger coefficients than this would take digits.
inline constexpr double kLargestShare = 10;

}  // namespace holdfast
