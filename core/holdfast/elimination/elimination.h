#pragma once
/// The elimination of the hard constraints B u = d, (12): what they give, and what they leave free.

#include <vector>

#include <holdfast/elimination/block_elimination.h>
#include <holdfast/elimination/merged_unknowns.h>

namespace holdfast {

/// Splits displacements: u = particular(d) + Q2 z has B u = d for every z for which the rows `kept()` of B Q2 z are 0.
/// Unknowns that difference rows tie together are one group, with one column however many they are; everything else is
/// eliminated over groups, block by block.
class Elimination {
 public:
  /// `independent` names independent rows, ascending. Unknowns with `isHeld` have the displacement 0; no row names one.
  Elimination(const std::vector<RowTerms>& rows, const std::vector<Index>& independent, Index unknownCount,
              const std::vector<bool>& isHeld);

  /// n x k, orthogonal columns that span the displacements with B u = 0 in all rows that are not kept, and 0 where
  /// held. A free unknown has an identity column, a free group one of ones. Made anew: O(n + its entries).
  [[nodiscard]] SparseMatrix Q2() const;

  /// k. O(n).
  [[nodiscard]] Index freeCount() const { return blocks_.freeCount(); }

  /// The independent rows of large components, ascending. A basis of what they leave free would be nearly dense, so
  /// they stay in the system that is solved, with multipliers.
  [[nodiscard]] std::vector<Index> kept() const;

  /// Q2 with no row kept: spans the displacements with B u = 0. O(its entries), which may be as many as the square of
  /// the unknowns of a large component.
  [[nodiscard]] SparseMatrix wholeQ2() const;

  /// The displacement in the span of the rows with B u = d, n x 3. `d` has a row for each row that the constructor was
  /// given; those that are not independent are not looked at. Pins are copied bit for bit.
  [[nodiscard]] Columns3 particular(const Columns3& d) const;

  /// The Lagrange multipliers l of the rows with B^T l = `gradient` (n x 3), which Q2 maps to zero: rows x 3, zero for
  /// rows that are not independent.
  [[nodiscard]] Columns3 multipliers(const Columns3& gradient) const;

  /// How far unknowns move, all together, for a unit of change in what one row asks for while all others hold: the
  /// length of that row's column of the pseudo-inverse of B. For each row; 0 for those that are not independent.
  /// Estimated to some twenty per cent in blocks of more than 512 rows.
  [[nodiscard]] std::vector<double> sensitivities() const;

 private:
  std::vector<Index> others_;  // the independent rows that are no differences
  MergedUnknowns merged_;
  // Empty without links.
  SparseMatrix membership_;
  std::vector<RowTerms> rows_;
  std::vector<RowTerms> contracted_;  // every row, over groups
  BlockElimination blocks_;
};

}  // namespace holdfast
