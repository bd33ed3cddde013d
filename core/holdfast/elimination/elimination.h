#pragma once
/// The elimination of the hard constraints B u = d, (12): what they give, and what they leave free.

#include <vector>

#include <holdfast/elimination/block_elimination.h>
#include <holdfast/elimination/merged_unknowns.h>

namespace holdfast {

/// An elimination splits displacements into u = particular(d) + Q2 z. This has B u = d for every z for which the rows
/// `kept()` of B Q2 z are 0. Unknowns that difference rows tie together are one group. The group has one column,
/// however many unknowns it has. Everything else is eliminated over groups, block by block.
class Elimination {
 public:
  /// `independent` names independent rows, ascending. Unknowns with `isHeld` have the displacement 0, and no row names
  /// them.
  Elimination(const std::vector<RowTerms>& rows, const std::vector<Index>& independent, Index unknownCount,
              const std::vector<bool>& isHeld);

  /// Returns Q2, n x k, with orthogonal columns. They span the displacements that have B u = 0 in all rows that are not
  /// kept and are 0 where held. A free unknown has an identity column. A free group has a column of ones. Each call
  /// makes the matrix anew: O(n + its entries).
  [[nodiscard]] SparseMatrix Q2() const;

  /// Returns k, the number of columns of Q2. O(n).
  [[nodiscard]] Index freeCount() const { return blocks_.freeCount(); }

  /// Returns the rows that are kept, ascending: independent rows of large components. A basis of what they leave free
  /// would be nearly dense. So they stay in the system that is solved, with multipliers.
  [[nodiscard]] std::vector<Index> kept() const;

  /// Returns a Q2 for which no row is kept: it spans the displacements with B u = 0. O(its entries), which may be as
  /// many as the square of the unknowns of a large component.
  [[nodiscard]] SparseMatrix wholeQ2() const;

  /// Returns the displacement in the span of the rows with B u = d, n x 3. `d` has a row for each row that the
  /// constructor was given. The call ignores those of rows that are not independent. Pins are copied bit for bit.
  [[nodiscard]] Columns3 particular(const Columns3& d) const;

  /// Returns the Lagrange multipliers l of the rows, rows x 3, with B^T l = `gradient` (n x 3). Q2^T must map
  /// `gradient` to zero. Rows that are not independent have zeros.
  [[nodiscard]] Columns3 multipliers(const Columns3& gradient) const;

  /// Returns the sensitivity of each row: how far unknowns move, all together, when what the row asks for changes by
  /// one unit. All other rows hold meanwhile. It is the length of the row's column of the pseudo-inverse of B. Rows
  /// that are not independent have 0. Blocks of more than 512 rows have estimates, to some twenty per cent.
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
