#include "holdfast/elimination/row_matching.h"

namespace holdfast {
namespace {

constexpr Index kNoRow = -1;
constexpr Index kFromRow = -1;

/// Rows with an unknown each, by paths along which each row hands its unknown on.
class RowMatching {
 public:
  RowMatching(const std::vector<RowTerms>& rows, Index unknownCount)
      : rows_(rows),
        rowOf_(static_cast<std::size_t>(unknownCount), kNoRow),
        searchOf_(static_cast<std::size_t>(unknownCount), 0),
        from_(static_cast<std::size_t>(unknownCount), kFromRow)
  {
  }

  /// Tells whether the row gets an unknown.
  bool add(Index row)
  {
    ++search_;
    reached_.clear();
    reach(rows_[row], kFromRow);
    for (std::size_t k = 0; k < reached_.size(); ++k) {  // grows meanwhile
      const Index unknown = reached_[k];
      if (rowOf_[unknown] == kNoRow) return handOn(unknown, row);
      reach(rows_[rowOf_[unknown]], unknown);
    }
    for (const Index unknown : reached_) searchOf_[unknown] = kExhausted;
    return false;
  }

  /// The row that has the unknown; `kNoRow` where none does.
  [[nodiscard]] Index rowOf(Index unknown) const { return rowOf_[unknown]; }

 private:
  static constexpr Index kExhausted = -1;

  void reach(const RowTerms& row, Index from)
  {
    for (const Term& term : row) {
      Index& search = searchOf_[term.index];
      if (search == kExhausted || search == search_) continue;
      search = search_;
      from_[term.index] = from;
      reached_.push_back(term.index);
    }
  }

  bool handOn(Index unknown, Index row)
  {
    for (; from_[unknown] != kFromRow; unknown = from_[unknown]) rowOf_[unknown] = rowOf_[from_[unknown]];
    rowOf_[unknown] = row;
    return true;
  }

  const std::vector<RowTerms>& rows_;
  std::vector<Index> rowOf_;     // of each unknown
  std::vector<Index> searchOf_;  // the last search that reached it
  std::vector<Index> from_;      // the unknown from whose row it was reached
  std::vector<Index> reached_;
  Index search_ = 0;
};

}  // namespace

std::vector<Index> matchedRows(const std::vector<RowTerms>& rows, const std::vector<Index>& order, Index unknownCount)
{
  RowMatching matching(rows, unknownCount);
  std::vector<Index> result;
  for (const Index row : order)
    if (matching.add(row)) result.push_back(row);
  return result;
}

std::vector<bool> freeUnknowns(const std::vector<RowTerms>& rows, Index unknownCount)
{
  RowMatching matching(rows, unknownCount);
  std::vector<Index> takes(rows.size(), 0);  // of each row, the unknown that it has
  for (std::size_t r = 0; r < rows.size(); ++r) matching.add(static_cast<Index>(r));
  const IndexLists rowsOf = rowsOfUnknowns(rows, unknownCount);
  std::vector<bool> isFree(static_cast<std::size_t>(unknownCount), false);
  std::vector<Index> found;
  const auto find = [&](Index unknown) {
    if (isFree[unknown]) return;
    isFree[unknown] = true;
    found.push_back(unknown);
  };
  for (Index u = 0; u < unknownCount; ++u)
    if (matching.rowOf(u) == kNoRow)
      find(u);
    else
      takes[matching.rowOf(u)] = u;
  for (std::size_t k = 0; k < found.size(); ++k)  // grows meanwhile
    for (const Index row : rowsOf[found[k]]) find(takes[row]);
  return isFree;
}

}  // namespace holdfast
