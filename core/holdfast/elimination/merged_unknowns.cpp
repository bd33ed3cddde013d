#include "holdfast/elimination/merged_unknowns.h"

#include <cmath>
#include <functional>
#include <map>
#include <numeric>

#include <holdfast/matrices/sparse_products.h>

namespace holdfast {
namespace {

constexpr Index kNoGroup = -1;
constexpr Index kNoLink = -1;

struct Neighbour {
  Index unknown;
  Index row;
  double sign;
};

std::vector<std::vector<Neighbour>> neighbours(const std::vector<RowTerms>& rows, const std::vector<Index>& differences,
                                               Index unknownCount)
{
  std::vector<std::vector<Neighbour>> result(static_cast<std::size_t>(unknownCount));
  for (const Index row : differences) {
    const Difference difference = *differenceOf(rows[row]);
    result[difference.from].push_back({difference.to, row, 1});
    result[difference.to].push_back({difference.from, row, -1});
  }
  return result;
}

}  // namespace

std::optional<Difference> differenceOf(const RowTerms& row)
{
  if (row.size() != 2 || std::abs(row[0].coefficient) != 1 || row[0].coefficient != -row[1].coefficient)
    return std::nullopt;
  return row[0].coefficient < 0 ? Difference{row[0].index, row[1].index} : Difference{row[1].index, row[0].index};
}

MergedUnknowns::MergedUnknowns(const std::vector<RowTerms>& rows, const std::vector<Index>& differences,
                               Index unknownCount)
    : groupOf_(static_cast<std::size_t>(unknownCount), kNoGroup)
{
  if (differences.empty()) {
    std::iota(groupOf_.begin(), groupOf_.end(), Index{0});
    count_ = unknownCount;
    return;
  }
  linkOf_.resize(groupOf_.size(), kNoLink);
  const std::vector<std::vector<Neighbour>> adjacent = neighbours(rows, differences, unknownCount);
  for (Index first = 0; first < unknownCount; ++first) {
    if (groupOf_[first] != kNoGroup) continue;
    groupOf_[first] = count_;
    firstLinkOf_.push_back(static_cast<Index>(links_.size()));
    std::vector<Index> reached{first};
    for (std::size_t k = 0; k < reached.size(); ++k)
      for (const Neighbour& next : adjacent[reached[k]]) {
        if (groupOf_[next.unknown] != kNoGroup) continue;
        groupOf_[next.unknown] = count_;
        linkOf_[next.unknown] = static_cast<Index>(links_.size());
        links_.push_back({next.unknown, reached[k], next.row, next.sign, 1});
        reached.push_back(next.unknown);
      }
    ++count_;
  }
  firstLinkOf_.push_back(static_cast<Index>(links_.size()));
  for (auto link = links_.rbegin(); link != links_.rend(); ++link)
    if (const Index above = linkOf_[link->parent]; above != kNoLink) links_[above].hanging += link->hanging;
}

std::span<const MergedUnknowns::Link> MergedUnknowns::linksOf(Index group) const
{
  const std::span<const Link> links(links_);
  if (links.empty()) return links;
  return links.subspan(firstLinkOf_[group], firstLinkOf_[group + 1] - firstLinkOf_[group]);
}

RowTerms MergedUnknowns::contracted(const RowTerms& row) const
{
  if (links_.empty()) return row;
  std::map<Index, double> weights;
  for (const Term& term : row) weights[groupOf_[term.index]] += term.coefficient;
  RowTerms result;
  for (const auto& [group, weight] : weights)
    if (std::abs(weight) > kVanishingWeight) result.push_back({group, weight});
  // Shares of a point that lies in one group sum to 1 up to rounding.
  if (result.size() == 1 && std::abs(result.front().coefficient - 1) <= kVanishingWeight)
    result.front().coefficient = 1;
  return result;
}

SparseMatrix MergedUnknowns::membership() const
{
  return assembled<SparseRows>(static_cast<Index>(groupOf_.size()), count_,
                               [&](Index u, ColumnSum& sum) { sum.add(static_cast<int>(groupOf_[u]), 1); });
}

Columns3 MergedUnknowns::offsets(const Columns3& d) const
{
  Columns3 result = Columns3::Zero(static_cast<Index>(groupOf_.size()), 3);
  for (const Link& link : links_) result.row(link.unknown) = result.row(link.parent) + link.sign * d.row(link.row);
  return result;
}

std::vector<Term> MergedUnknowns::combinationOf(const RowTerms& terms) const
{
  if (links_.empty()) return {};
  std::map<Index, double, std::greater<>> pending;  // by link: children before parents
  for (const Term& term : terms)
    if (linkOf_[term.index] != kNoLink) pending[linkOf_[term.index]] += term.coefficient;
  std::vector<Term> result;
  while (!pending.empty()) {
    const auto [place, total] = *pending.begin();
    pending.erase(pending.begin());
    const Link& link = links_[place];
    result.push_back({link.row, link.sign * total});
    if (linkOf_[link.parent] != kNoLink) pending[linkOf_[link.parent]] += total;
  }
  return result;
}

Columns3 MergedUnknowns::combinationOf(Columns3 totals, Index rowCount) const
{
  Columns3 result = Columns3::Zero(rowCount, 3);
  for (auto link = links_.rbegin(); link != links_.rend(); ++link) {
    result.row(link->row) = link->sign * totals.row(link->unknown);
    totals.row(link->parent) += totals.row(link->unknown);
  }
  return result;
}

}  // namespace holdfast
