#include "holdfast/factor/multipliers.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace holdfast {
namespace {

// A row is matched with a column only if its entry there is at least this share of its largest one.
constexpr double kThreshold = 0.1;

struct Entry {
  int column;  // place in the order of elimination
  double value;
};
using Row = std::vector<Entry>;  // ascending

/// The rows of K, below M in `lower`.
std::vector<Row> rowsOf(const SparseMatrix& lower, int size)
{
  std::vector<Row> rows(static_cast<std::size_t>(lower.cols() - size));
  for (int k = 0; k < size; ++k)
    for (SparseMatrix::InnerIterator entry(lower, k); entry; ++entry)
      if (entry.row() >= size) rows[entry.row() - size].push_back({k, entry.value()});
  return rows;
}

double shareOfFirst(const Row& row)
{
  double largest = 0;
  for (const Entry& entry : row) largest = std::max(largest, std::abs(entry.value));
  return std::abs(row.front().value) / largest;
}

/// row - factor pivot, without the first column of both.
Row eliminated(const Row& row, double factor, const Row& pivot)
{
  Row result;
  result.reserve(row.size() + pivot.size());
  auto a = row.begin() + 1;
  auto b = pivot.begin() + 1;
  while (a != row.end() || b != pivot.end()) {
    const bool takesA = b == pivot.end() || (a != row.end() && a->column <= b->column);
    const bool takesB = a == row.end() || (b != pivot.end() && b->column <= a->column);
    const int column = takesA ? a->column : b->column;
    const double value = takesA ? (a++)->value : 0;
    result.push_back({column, takesB ? value - factor * (b++)->value : value});
  }
  return result;
}

/// The column that each row is matched with.
std::vector<int> matchedColumns(std::vector<Row> rows, int columnCount)
{
  std::vector<std::vector<int>> startingAt(static_cast<std::size_t>(columnCount));
  std::vector<int> result(rows.size(), columnCount - 1);
  for (std::size_t j = 0; j < rows.size(); ++j) startingAt[rows[j].front().column].push_back(static_cast<int>(j));
  for (int column = 0; column < columnCount; ++column) {
    const std::vector<int> open = std::exchange(startingAt[column], {});
    int pivot = -1;
    double best = kThreshold;
    for (const int j : open)
      if (const double share = shareOfFirst(rows[j]); share >= best) {
        best = share;
        pivot = j;
      }
    for (const int j : open) {
      if (j == pivot) {
        result[j] = column;
        continue;
      }
      if (pivot < 0)
        rows[j].erase(rows[j].begin());
      else
        rows[j] = eliminated(rows[j], rows[j].front().value / rows[pivot].front().value, rows[pivot]);
      if (!rows[j].empty()) startingAt[rows[j].front().column].push_back(j);
    }
    if (pivot >= 0) rows[pivot] = {};
  }
  return result;
}

}  // namespace

SymbolicFactor withMultipliers(const SymbolicFactor& ofM, SparseMatrix& lower)
{
  std::vector<int> supernodeOf;
  for (std::size_t s = 0; s < ofM.supernodes.size(); ++s)
    supernodeOf.insert(supernodeOf.end(), static_cast<std::size_t>(ofM.supernodes[s].width), static_cast<int>(s));
  std::vector<std::vector<int>> multipliersOf(ofM.supernodes.size());
  const std::vector<int> matched = matchedColumns(rowsOf(lower, ofM.size()), ofM.size());
  for (std::size_t j = 0; j < matched.size(); ++j)
    multipliersOf[supernodeOf[matched[j]]].push_back(ofM.size() + static_cast<int>(j));

  SymbolicFactor factor;
  for (std::size_t s = 0; s < ofM.supernodes.size(); ++s) {
    Supernode node{factor.size(), ofM.supernodes[s].width};
    for (int k = 0; k < node.width; ++k) factor.order.push_back(ofM.supernodes[s].firstColumn + k);
    factor.order.insert(factor.order.end(), multipliersOf[s].begin(), multipliersOf[s].end());
    node.multipliers = static_cast<int>(multipliersOf[s].size());
    node.width += node.multipliers;
    factor.supernodes.push_back(node);
  }
  factor.subtrees = ofM.subtrees;
  factor.top = ofM.top;
  lower = inOrder(lower, factor.order);
  complete(factor, lower);
  for (int& column : factor.order)
    if (column < ofM.size()) column = ofM.order[column];
  return factor;
}

}  // namespace holdfast
