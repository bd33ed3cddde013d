#include "holdfast/elimination/row_components.h"

#include <algorithm>

#include <holdfast/matrices/sparse_products.h>
#include <holdfast/numbers/disjoint_sets.h>

namespace holdfast {
namespace {

// Beyond this a sparse factorisation is faster than a dense one of the same block.
constexpr std::size_t kDenseRows = 64;
constexpr std::size_t kDenseUnknowns = 256;

}  // namespace

std::vector<Index> unknownsOf(const std::vector<RowTerms>& rows, const std::vector<Index>& some)
{
  std::vector<Index> unknowns;
  for (const Index row : some)
    for (const Term& term : rows[row]) unknowns.push_back(term.index);
  return sortedOnce(std::move(unknowns));
}

IndexLists rowsOfUnknowns(const std::vector<RowTerms>& rows, Index unknownCount)
{
  return IndexLists(unknownCount, [&](const auto& add) {
    for (std::size_t r = 0; r < rows.size(); ++r)
      for (const Term& term : rows[r]) add(term.index, static_cast<Index>(r));
  });
}

std::vector<RowComponent> connectedRows(const std::vector<RowTerms>& rows, Index unknownCount)
{
  DisjointSets sets(unknownCount);
  for (const RowTerms& row : rows)
    for (const Term& term : row) sets.unite(row.front().index, term.index);

  std::vector<RowComponent> components;
  std::vector<Index> componentOf(static_cast<std::size_t>(unknownCount), -1);  // by representative
  for (std::size_t r = 0; r < rows.size(); ++r) {
    if (rows[r].empty()) continue;
    Index& component = componentOf[sets.find(rows[r].front().index)];
    if (component < 0) {
      component = static_cast<Index>(components.size());
      components.emplace_back();
    }
    components[component].rows.push_back(static_cast<Index>(r));
  }
  for (RowComponent& component : components) component.unknowns = unknownsOf(rows, component.rows);
  return components;
}

std::vector<RowTerms> localRows(const std::vector<RowTerms>& rows, const RowComponent& component)
{
  std::vector<RowTerms> result;
  result.reserve(component.rows.size());
  for (const Index row : component.rows) {
    RowTerms& local = result.emplace_back(rows[row]);
    for (Term& term : local)
      term.index = std::ranges::lower_bound(component.unknowns, term.index) - component.unknowns.begin();
  }
  return result;
}

SparseMatrix transposedBlock(const std::vector<RowTerms>& rows, const RowComponent& component)
{
  std::vector<Eigen::Triplet<double, int>> entries;
  for (std::size_t k = 0; k < component.rows.size(); ++k)
    for (const Term& term : rows[component.rows[k]]) {
      const auto place = std::lower_bound(component.unknowns.begin(), component.unknowns.end(), term.index);
      entries.emplace_back(static_cast<int>(place - component.unknowns.begin()), static_cast<int>(k), term.coefficient);
    }
  SparseMatrix block(static_cast<Index>(component.unknowns.size()), static_cast<Index>(component.rows.size()));
  block.setFromTriplets(entries.begin(), entries.end());
  return block;
}

bool isDense(const RowComponent& component)
{
  return component.rows.size() <= kDenseRows && component.unknowns.size() <= kDenseUnknowns;
}

SparseMatrix constraintMatrix(const std::vector<RowTerms>& rows, Index unknownCount)
{
  return assembled<SparseRows>(static_cast<Index>(rows.size()), unknownCount, [&](Index r, ColumnSum& sum) {
    for (const Term& term : rows[r]) sum.add(static_cast<int>(term.index), term.coefficient);
  });
}

}  // namespace holdfast
