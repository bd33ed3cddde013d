#pragma once
/// Rows that have an unknown of their own: each is solved for it without arithmetic on other rows.

#include <vector>

#include <holdfast/elimination/row_components.h>

namespace holdfast {

struct OwnUnknown {
  Index row = 0;
  Index unknown = 0;
};

/// Some of `rows`, each with an unknown that neither the rows behind it in this list name nor those that are not in
/// it. No row outside depends on one of the list, nor one of the list on any other: moving the own unknowns alone meets
/// a row with 1 and all others of `rows` with 0. A row is in the list only if they move by at most `kMostMoved` in all
/// for that. Points at random in up to 0.8 faces for each vertex leave few rows outside. O(terms).
[[nodiscard]] std::vector<OwnUnknown> ownUnknowns(const std::vector<RowTerms>& rows, Index unknownCount);

/// A bound of the sensitivities of rows with own unknowns: far below the inverse of the rank tolerance.
inline constexpr double kMostMoved = 100;

/// Displacements that rows of a list map to zero.
struct SubstitutedRows {
  SparseMatrix basis;       ///< unknowns x free ones: 1 at a free unknown, and what the own unknowns follow by
  std::vector<Index> kept;  ///< ascending: the rows that are not substituted, which the basis does not meet
};

/// Substitutes own unknowns by the others of their rows, where no coefficient exceeds `kLargestShare`. O(entries).
[[nodiscard]] SubstitutedRows substituted(const std::vector<RowTerms>& rows, Index unknownCount);

/// Larger coefficients would take digits: the basis is not orthogonal.
inline constexpr double kLargestShare = 10;

}  // namespace holdfast
