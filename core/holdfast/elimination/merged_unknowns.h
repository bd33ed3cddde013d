#pragma once
/// Unknowns that rows tie to one another at given differences: each group of them moves as one. The vectors of rigid
/// regions, equation (28), and of Fig. 8.

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

/// The two unknowns of a row with the coefficients -1 and +1; nothing for any other row.
[[nodiscard]] std::optional<Difference> differenceOf(const RowTerms& row);

/// The groups that some difference rows make, a spanning tree in each. An unknown that no row names is a group of its
/// own. An unknown of a group is where the group is, plus its offset.
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

  /// How many there are; they are numbered by their first unknowns.
  [[nodiscard]] Index count() const noexcept { return count_; }
  [[nodiscard]] Index groupOf(Index unknown) const { return groupOf_[unknown]; }

  /// Whether any group has more than one unknown.
  [[nodiscard]] bool hasLinks() const { return !links_.empty(); }
  /// The links of a group, parents before children: one fewer than it has unknowns.
  [[nodiscard]] std::span<const Link> linksOf(Index group) const;
  [[nodiscard]] Index sizeOf(Index group) const { return static_cast<Index>(linksOf(group).size()) + 1; }

  /// A row over unknowns as one over groups; terms that cancel are left out. A row that holds inside a group is empty.
  [[nodiscard]] RowTerms contracted(const RowTerms& row) const;

  /// n x count, one entry of 1 in each row.
  [[nodiscard]] SparseMatrix membership() const;

  /// How far each unknown is from its group when difference row k is d_k: n x 3.
  [[nodiscard]] Columns3 offsets(const Columns3& d) const;

  /// For each difference row that terms hang on, the sum of their coefficients times its sign. Where coefficients sum
  /// to zero over each group this is the combination of difference rows that is `terms`.
  [[nodiscard]] std::vector<Term> combinationOf(const RowTerms& terms) const;

  /// The same for many at a time: `totals` (n x 3, each column summing to zero over each group) is the sum of
  /// coefficient times row; the coefficients of difference rows (rows x 3). O(n).
  [[nodiscard]] Columns3 combinationOf(Columns3 totals, Index rowCount) const;

 private:
  Index count_ = 0;
  std::vector<Index> groupOf_;
  std::vector<Link> links_;         // group by group, parents before children
  std::vector<Index> firstLinkOf_;  // of each group, and their number at the end
  std::vector<Index> linkOf_;       // of each unknown, -1 for the first of a group; these two are empty without links
};

}  // namespace holdfast
