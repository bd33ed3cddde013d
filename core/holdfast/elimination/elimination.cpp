#include "holdfast/elimination/elimination.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <holdfast/elimination/find_dependencies.h>

namespace holdfast {
namespace {

double rootOfSize(const MergedUnknowns& groups, Index group)
{
  return std::sqrt(static_cast<double>(groups.sizeOf(group)));
}

/// The rows of a component of contracted rows, over the coordinates w_b = sqrt(n_b) v_b of its groups: |w| is the
/// length over all unknowns.
std::vector<RowTerms> scaledRows(const RowComponent& component, const std::vector<RowTerms>& contracted,
                                 const MergedUnknowns& groups)
{
  std::vector<RowTerms> result = localRows(contracted, component);
  for (RowTerms& row : result)
    for (Term& term : row) term.coefficient /= rootOfSize(groups, component.unknowns[term.index]);
  return result;
}

/// What the rows have at this unknown, by their places.
RowTerms columnOf(const std::vector<RowTerms>& rows, std::size_t unknown)
{
  RowTerms result;
  for (std::size_t k = 0; k < rows.size(); ++k)
    for (const Term& term : rows[k])
      if (term.index == static_cast<Index>(unknown)) result.push_back({static_cast<Index>(k), term.coefficient});
  return result;
}

/// By difference row: what a unit of it is in the rows of a component, by their places, where only the unknowns that
/// hang on it move.
std::map<Index, RowTerms> valuesByDifference(const RowComponent& component, const std::vector<RowTerms>& rows,
                                             const MergedUnknowns& groups)
{
  std::map<Index, RowTerms> result;
  for (std::size_t k = 0; k < component.rows.size(); ++k)
    for (const Term& difference : groups.combinationOf(rows[component.rows[k]]))
      result[difference.index].push_back({static_cast<Index>(k), difference.coefficient});
  return result;
}

/// A difference row moves the s of n unknowns that hang on it against the others, about the centroid of their group.
double spread(const MergedUnknowns::Link& link, const MergedUnknowns& groups)
{
  const auto n = static_cast<double>(groups.sizeOf(groups.groupOf(link.unknown)));
  const auto s = static_cast<double>(link.hanging);
  return std::sqrt(s * (n - s) / n);
}

/// The rows of one component, and the difference rows of its groups.
void spreadOverComponent(std::vector<double>& sensitivities, const RowComponent& component,
                         const std::vector<RowTerms>& rows, const std::vector<RowTerms>& contracted,
                         const MergedUnknowns& groups)
{
  const std::vector<RowTerms> scaled = scaledRows(component, contracted, groups);
  const BlockElimination elimination(scaled, independentRows({}, scaled.size()),
                                     static_cast<Index>(component.unknowns.size()),
                                     std::vector<bool>(component.unknowns.size(), false));
  const std::vector<double> ofRows = elimination.sensitivities();
  for (std::size_t k = 0; k < ofRows.size(); ++k)
    sensitivities[component.rows[k]] = std::max(sensitivities[component.rows[k]], ofRows[k]);

  // The shortest w for which these rows have these values, and all others 0.
  const auto shortest = [&](const RowTerms& values) -> Eigen::VectorXd {
    Columns3 d = Columns3::Zero(static_cast<Index>(scaled.size()), 3);
    for (const Term& value : values) d(value.index, 0) = value.coefficient;
    return elimination.particular(d).col(0);
  };
  // Where a difference row changes, groups have to move as well, so that the other rows stay met.
  const std::map<Index, RowTerms> values = valuesByDifference(component, rows, groups);
  for (std::size_t b = 0; b < component.unknowns.size(); ++b) {
    const std::span<const MergedUnknowns::Link> links = groups.linksOf(component.unknowns[b]);
    if (links.empty()) continue;
    const Eigen::VectorXd centroid = shortest(columnOf(scaled, b)) / rootOfSize(groups, component.unknowns[b]);
    const double length = centroid.norm();
    for (const MergedUnknowns::Link& link : links) {
      const auto s = static_cast<double>(link.hanging);
      const auto own = values.find(link.row);
      const double moved = own == values.end() ? s * length : (shortest(own->second) - link.sign * s * centroid).norm();
      sensitivities[link.row] = std::hypot(spread(link, groups), moved);
    }
  }
}

/// Raises `sensitivities`, one for each row and measured over groups, to what they are over unknowns: the lengths of
/// the columns of the pseudo-inverse of B. `contracted` are the rows over `groups`, those in `others` independent of
/// one another; the difference rows that tie the groups have no sensitivity before. Groups that no other row names
/// take O(1) a row; a component of other rows takes an elimination, and one solution of it for each difference row
/// that separates its points.
void spreadOverMerged(std::vector<double>& sensitivities, const std::vector<RowTerms>& rows,
                      const std::vector<RowTerms>& contracted, const std::vector<Index>& others,
                      const MergedUnknowns& groups)
{
  for (Index group = 0; group < groups.count(); ++group)
    for (const MergedUnknowns::Link& link : groups.linksOf(group)) sensitivities[link.row] = spread(link, groups);
  std::vector<RowTerms> left(rows.size());
  for (const Index row : others) left[row] = contracted[row];
  for (const RowComponent& component : connectedRows(left, groups.count()))
    if (std::any_of(component.unknowns.begin(), component.unknowns.end(),
                    [&](Index group) { return groups.sizeOf(group) > 1; }))
      spreadOverComponent(sensitivities, component, rows, contracted, groups);
}

template <class Predicate>
std::vector<Index> filtered(const std::vector<Index>& rows, Predicate isWanted)
{
  std::vector<Index> result;
  std::ranges::copy_if(rows, std::back_inserter(result), isWanted);
  return result;
}

std::vector<RowTerms> contractedRows(const std::vector<RowTerms>& rows, const MergedUnknowns& groups)
{
  std::vector<RowTerms> result;
  result.reserve(rows.size());
  for (const RowTerms& row : rows) result.push_back(groups.contracted(row));
  return result;
}

/// A row joins held unknowns with held ones only, so a group is held as a whole or not at all.
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
    : others_(filtered(independent, [&](Index row) { return !differenceOf(rows[row]); })),
      merged_(rows, filtered(independent, [&](Index row) { return differenceOf(rows[row]).has_value(); }),
              unknownCount),
      membership_(merged_.hasLinks() ? merged_.membership() : SparseMatrix()),
      rows_(merged_.hasLinks() ? rows : std::vector<RowTerms>()),
      contracted_(contractedRows(rows_, merged_)),
      blocks_(merged_.hasLinks() ? contracted_ : rows, others_, merged_.count(), heldGroups(isHeld, merged_))
{
}

SparseMatrix Elimination::Q2() const
{
  return merged_.hasLinks() ? SparseMatrix(membership_ * blocks_.Q2()) : blocks_.Q2();
}

Columns3 Elimination::particular(const Columns3& d) const
{
  if (!merged_.hasLinks()) return blocks_.particular(d);
  const Columns3 offsets = merged_.offsets(d);
  Columns3 askedOfGroups = d;
  for (std::size_t r = 0; r < rows_.size(); ++r)
    for (const Term& term : rows_[r]) askedOfGroups.row(r) -= term.coefficient * offsets.row(term.index);
  return offsets + membership_ * blocks_.particular(askedOfGroups);
}

std::vector<Index> Elimination::kept() const
{
  std::vector<Index> result;
  for (const BlockElimination::Block& block : blocks_.blocks())
    for (const FreePart& part : block.parts)
      for (const Index row : part.kept) result.push_back(block.rows[row]);
  std::ranges::sort(result);
  return result;
}

SparseMatrix Elimination::wholeQ2() const
{
  return merged_.hasLinks() ? SparseMatrix(membership_ * blocks_.wholeQ2()) : blocks_.wholeQ2();
}

Columns3 Elimination::multipliers(const Columns3& gradient) const
{
  if (!merged_.hasLinks()) return blocks_.multipliers(gradient);
  Columns3 result = blocks_.multipliers(membership_.transpose() * gradient);
  Columns3 left = gradient;
  for (const Index row : others_)
    for (const Term& term : rows_[row]) left.row(term.index) -= term.coefficient * result.row(row);
  return result + merged_.combinationOf(std::move(left), static_cast<Index>(rows_.size()));
}

std::vector<double> Elimination::sensitivities() const
{
  std::vector<double> result = blocks_.sensitivities();
  if (merged_.hasLinks()) spreadOverMerged(result, rows_, contracted_, others_, merged_);
  return result;
}

}  // namespace holdfast
