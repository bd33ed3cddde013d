#include "holdfast/elimination/own_unknowns.h"

#include <algorithm>
#include <cmath>

#include <holdfast/matrices/sparse_products.h>

namespace holdfast {
namespace {

/// Takes rows away, one after the other, as long as one has an unknown that no row left names.
class OwnUnknownSearch {
 public:
  OwnUnknownSearch(const std::vector<RowTerms>& rows, Index unknownCount)
      : rows_(rows),
        rowsOf_(rowsOfUnknowns(rows, unknownCount)),
        left_(static_cast<std::size_t>(unknownCount)),
        pulled_(static_cast<std::size_t>(unknownCount), 1),
        isFound_(rows.size(), false)
  {
    for (Index u = 0; u < unknownCount; ++u) left_[u] = static_cast<Index>(rowsOf_[u].size());
  }

  std::vector<OwnUnknown> found() &&
  {
    for (std::size_t r = 0; r < rows_.size(); ++r) seek(static_cast<Index>(r));
    for (std::size_t k = 0; k < found_.size(); ++k)  // grows meanwhile
      for (const Term& term : rows_[found_[k].row])
        if (left_[term.index] == 1)
          for (const Index row : rowsOf_[term.index]) seek(row);
    return std::move(found_);
  }

 private:
  /// By which the own unknowns move least.
  void seek(Index row)
  {
    if (isFound_[row]) return;
    const Term* own = nullptr;
    const auto moved = [&](const Term& term) { return pulled_[term.index] / std::abs(term.coefficient); };
    for (const Term& term : rows_[row])
      if (left_[term.index] == 1 && moved(term) <= (own == nullptr ? kMostMoved : moved(*own))) own = &term;
    if (own != nullptr) take(row, *own);
  }

  void take(Index row, const Term& own)
  {
    isFound_[row] = true;
    found_.push_back({row, own.index});
    const double moved = pulled_[own.index] / std::abs(own.coefficient);
    for (const Term& term : rows_[row]) {
      --left_[term.index];
      pulled_[term.index] += std::abs(term.coefficient) * moved;
    }
  }

  const std::vector<RowTerms>& rows_;
  IndexLists rowsOf_;
  std::vector<Index> left_;     // of each unknown: how many rows that are not found name it
  std::vector<double> pulled_;  // how far own unknowns move, at most, where it moves by 1 and the rows found are met
  std::vector<bool> isFound_;
  std::vector<OwnUnknown> found_;
};

/// Unknowns as sums of free ones; a free one is itself.
class Sums {
 public:
  explicit Sums(Index unknownCount)
      : of_(static_cast<std::size_t>(unknownCount)), isFree_(of_.size(), true), sum_(unknownCount)
  {
  }

  /// Substitutes the own unknown by the others of its row, unless a coefficient would be too large.
  bool substitute(const OwnUnknown& own, const RowTerms& row)
  {
    const double pivot = std::ranges::lower_bound(row, own.unknown, {}, &Term::index)->coefficient;
    for (const Term& term : row)
      if (term.index != own.unknown) add(term);
    SparseEntries entries;
    sum_.moveTo(entries);
    for (double& value : entries.values) value /= -pivot;
    if (std::ranges::any_of(entries.values, [](double value) { return std::abs(value) > kLargestShare; })) return false;
    isFree_[own.unknown] = false;
    of_[own.unknown] = std::move(entries);
    return true;
  }

  /// All of them by the free ones.
  [[nodiscard]] SparseMatrix basis() const
  {
    const auto count = static_cast<int>(of_.size());
    std::vector<int> columnOf(of_.size());
    int columns = 0;
    for (int u = 0; u < count; ++u) columnOf[u] = isFree_[u] ? columns++ : -1;
    std::vector<Eigen::Triplet<double, int>> entries;
    for (int u = 0; u < count; ++u) {
      if (isFree_[u]) entries.emplace_back(u, columnOf[u], 1.0);
      for (std::size_t k = 0; k < of_[u].places.size(); ++k)
        entries.emplace_back(u, columnOf[of_[u].places[k]], of_[u].values[k]);
    }
    SparseMatrix result(count, columns);
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
  }

 private:
  void add(const Term& term)
  {
    if (isFree_[term.index]) return sum_.add(static_cast<int>(term.index), term.coefficient);
    const SparseEntries& free = of_[term.index];
    for (std::size_t k = 0; k < free.places.size(); ++k) sum_.add(free.places[k], term.coefficient * free.values[k]);
  }

  std::vector<SparseEntries> of_;
  std::vector<bool> isFree_;
  ColumnSum sum_;
};

}  // namespace

std::vector<OwnUnknown> ownUnknowns(const std::vector<RowTerms>& rows, Index unknownCount)
{
  return OwnUnknownSearch(rows, unknownCount).found();
}

SubstitutedRows substituted(const std::vector<RowTerms>& rows, Index unknownCount)
{
  Sums sums(unknownCount);
  std::vector<bool> isKept(rows.size(), true);
  // The last ones first: no row names own unknowns of rows in front of it.
  const std::vector<OwnUnknown> found = ownUnknowns(rows, unknownCount);
  for (auto own = found.rbegin(); own != found.rend(); ++own) isKept[own->row] = !sums.substitute(*own, rows[own->row]);
  SubstitutedRows result{sums.basis(), {}};
  for (std::size_t r = 0; r < rows.size(); ++r)
    if (isKept[r]) result.kept.push_back(static_cast<Index>(r));
  return result;
}

}  // namespace holdfast
