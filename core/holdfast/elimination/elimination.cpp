#include "holdfast/elimination/elimination.h"

#include <utility>

#include <holdfast/elimination/body_amplifications.h>
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

std::vector<RowTerms> contractedRows(const std::vector<RowTerms>& rows, const Bodies& bodies)
{
  std::vector<RowTerms> result;
  result.reserve(rows.size());
  for (const RowTerms& row : rows) result.push_back(bodies.contracted(row));
  return result;
}

/// No row leads out of what is held: a body is held as a whole.
std::vector<bool> heldBodies(const std::vector<bool>& isHeld, const Bodies& bodies)
{
  std::vector<bool> result(static_cast<std::size_t>(bodies.count()), false);
  for (std::size_t u = 0; u < isHeld.size(); ++u)
    if (isHeld[u]) result[bodies.bodyOf(static_cast<Index>(u))] = true;
  return result;
}

}  // namespace

Elimination::Elimination(const std::vector<RowTerms>& rows, const std::vector<Index>& independent, Index unknownCount,
                         const std::vector<bool>& isHeld)
    : rows_(rows),
      others_(othersAmong(rows, independent)),
      bodies_(rows, differencesAmong(rows, independent), unknownCount),
      membership_(bodies_.membership()),
      contracted_(contractedRows(rows, bodies_)),
      blocks_(contracted_, others_, bodies_.count(), heldBodies(isHeld, bodies_)),
      Q2_(membership_ * blocks_.Q2())
{
}

Columns3 Elimination::particular(const Columns3& d) const
{
  const Columns3 offsets = bodies_.offsets(d);
  return offsets + membership_ * blocks_.particular(askedOfBodies(d, offsets));
}

Columns3 Elimination::reconciledParticular(const std::vector<Index>& redundant, const Columns3& d) const
{
  const Columns3 offsets = bodies_.offsets(d);
  return offsets + membership_ * reconciled(blocks_, contracted_, redundant, askedOfBodies(d, offsets));
}

Columns3 Elimination::askedOfBodies(const Columns3& d, const Columns3& offsets) const
{
  Columns3 result = d;
  for (std::size_t r = 0; r < rows_.size(); ++r)
    for (const PointTerm& term : rows_[r]) result.row(r) -= term.weight * offsets.row(term.vertex);
  return result;
}

Columns3 Elimination::multipliers(const Columns3& gradient) const
{
  Columns3 result = blocks_.multipliers(membership_.transpose() * gradient, static_cast<Index>(rows_.size()));
  Columns3 left = gradient;
  for (const Index row : others_)
    for (const PointTerm& term : rows_[row]) left.row(term.vertex) -= term.weight * result.row(row);
  return result + bodies_.combinationOf(std::move(left), static_cast<Index>(rows_.size()));
}

std::vector<double> Elimination::amplifications() const
{
  std::vector<double> result = blocks_.amplifications(rows_.size());
  amplifyBodies(result, rows_, contracted_, others_, bodies_);
  return result;
}

}  // namespace holdfast
