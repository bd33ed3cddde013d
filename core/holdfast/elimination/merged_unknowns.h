#pragma once
/// Unknowns that rows tie to one another at given differences: each group of them moves as one. Such rows are the
/// vectors of rigid regions, equation (28), and of Fig. 8.

#include <optional>
#include <span>
#include <vector>

#include <holdfast/elimination/row_components.h>

namespace holdfast {

/// A row x_to - x_from = d.
struct Difference {
  Index from = 0;
  Index to = 0;
};

/// Returns the two unknowns of a row with the coefficients -1 and +1, and nothing for any other row.
[[nodiscard]] std::optional<Difference> differenceOf(const RowTerms& row);

/// The groups that some difference rows make. The rows of a group are a spanning tree. An unknown that no row names is
/// a group of its own. An unknown lies where its group is, plus its offset.
class MergedUnknowns {
 public:
  /// An unknown that is not the first of its group hangs on another one by a row.
  struct Link {
    Index unknown;
    Index parent;
    Index row;
    double sign;    // x_unknown = x_parent + sign d_row
    Index hanging;  // how many unknowns hang on the row: this one and those that hang on it
  };

  /// `differences` names independent difference rows: they close no loop. O(n).
  MergedUnknowns(const std::vector<RowTerms>& rows, const std::vector<Index>& differences, Index unknownCount);

  /// Returns how many groups there are. They are numbered by their first unknowns.
  [[nodiscard]] Index count() const noexcept { return count_; }
  [[nodiscard]] Index groupOf(Index unknown) const { return groupOf_[unknown]; }

  /// Tells whether any group has more than one unknown.
  [[nodiscard]] bool hasLinks() const { return !links_.empty(); }
  /// Returns the links of a group, parents before children. They are one fewer than its unknowns.
  [[nodiscard]] std::span<const Link> linksOf(Index group) const;
  [[nodiscard]] Index sizeOf(Index group) const { return static_cast<Index>(linksOf(group).size()) + 1; }

  /// Returns a row over unknowns as a row over groups, without the terms that cancel. A row that holds inside a group
  /// becomes empty.
  [[nodiscard]] RowTerms contracted(const RowTerms& row) const;

  /// Returns the matrix, n x count, that has one entry of 1 in each row, in the column of the unknown's group.
  [[nodiscard]] SparseMatrix membership() const;

  /// Returns how far each unknown is from its group when difference row k is d_k: n x 3.
  [[nodiscard]] Columns3 offsets(const Columns3& d) const;

  /// Returns, for each difference row that terms hang on, the sum of their coefficients times its sign. Where
  /// coefficients sum to zero over each group, this is the combination of difference rows that equals `terms`.
  [[nodiscard]] std::vector<Term> combinationOf(const RowTerms& terms) const;

  /// Returns the coefficients of difference rows (rows x 3) for many combinations at a time. `totals` (n x 3) is the
  /// sum of coefficient times row. Each of its columns sums to zero over each group. O(n).
  [[nodiscard]] Columns3 combinationOf(Columns3 totals, Index rowCount) const;

 private:
  Index count_ = 0;
  std::vector<Index> groupOf_;
  std::vector<Link> links_;         // group by group, parents before children
  std::vector<Index> firstLinkOf_;  // of each group, and their number at the end
  std::vector<Index> linkOf_;       // of each unknown, -1 for the first of a group; these two are empty without links
};

}  // namespace holdfast
