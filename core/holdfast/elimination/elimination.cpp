#include "holdfast/elimination/elimination.h"

#include <utility>

#include <holdfast/elimination/merged_sensitivities.h>
#include <holdfast/elimination/reconciliation.h>

namespace holdfast {
namespace {

std::vector<Index> differencesAmong(const std::vector<RowTerms>& rows, const std::vector<Index>& some)
{
  std::vector<Index> result;
  for (const Index row : some)
    if (differenceOf(rows[row])) result.push_back(row);
  return result;
}

std::vector<Index> othersAmong(const std::vector<RowTerms>& rows, const std::vector<Index>& some)
{
  std::vector<Index> result;
  for (const Index row : some)
    if (!differenceOf(rows[row])) result.push_back(row);
  return result;
}

std::vector<RowTerms> contractedRows(const std::vector<RowTerms>& rows, const MergedUnknowns& groups)
{
  std::vector<RowTerms> result;
  result.reserve(rows.size());
  for (const RowTerms& row : rows) result.push_back(groups.contracted(row));
  return result;
}

/// No row leads out of what is held: a body is held as a whole.
std::vector<bool> heldGroups(const std::vector<bool>& isHeld, const MergedUnknowns& groups)
{
  std::vector<bool> result(static_cast<std::size_t>(groups.count()), false);
  for (std::size_t u = 0; u < isHeld.size(); ++u)
    if (isHeld[u]) result[groups.groupOf(static_cast<Index>(u))] = true;
  return result;
}

}  // namespace

Elimination::Elimination(const std::vector<RowTerms>& rows, const std::vector<Index>& independent, Index unknownCount,
                         const std::vector<bool>& isHeld)
    : rows_(rows),
      others_(othersAmong(rows, independent)),
      merged_(rows, differencesAmong(rows, independent), unknownCount),
      membership_(merged_.membership()),
      contracted_(contractedRows(rows, merged_)),
      blocks_(contracted_, others_, merged_.count(), heldGroups(isHeld, merged_)),
      Q2_(membership_ * blocks_.Q2())
{
}

Columns3 Elimination::particular(const Columns3& d) const
{
  const Columns3 offsets = merged_.offsets(d);
  return offsets + membership_ * blocks_.particular(askedOfGroups(d, offsets));
}

Columns3 Elimination::reconciledParticular(const std::vector<Index>& redundant, const Columns3& d) const
{
  const Columns3 offsets = merged_.offsets(d);
  return offsets + membership_ * reconciled(blocks_, contracted_, redundant, askedOfGroups(d, offsets));
}

Columns3 Elimination::askedOfGroups(const Columns3& d, const Columns3& offsets) const
{
  Columns3 result = d;
  for (std::size_t r = 0; r < rows_.size(); ++r)
    for (const Term& term : rows_[r]) result.row(r) -= term.coefficient * offsets.row(term.index);
  return result;
}

Columns3 Elimination::multipliers(const Columns3& gradient) const
{
  Columns3 result = blocks_.multipliers(membership_.transpose() * gradient, static_cast<Index>(rows_.size()));
  Columns3 left = gradient;
  for (const Index row : others_)
    for (const Term& term : rows_[row]) left.row(term.index) -= term.coefficient * result.row(row);
  return result + merged_.combinationOf(std::move(left), static_cast<Index>(rows_.size()));
}

std::vector<double> Elimination::sensitivities() const
{
  std::vector<double> result = blocks_.sensitivities(rows_.size());
  spreadOverMerged(result, rows_, contracted_, others_, merged_);
  return result;
}

}  // namespace holdfast
