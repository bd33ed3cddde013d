#include "holdfast/ordering/elimination_order.h"

#include <algorithm>
#include <numeric>

#include <holdfast/base/sparse_products.h>
#include <holdfast/operators/laplacian.h>
#include <holdfast/ordering/nested_dissection.h>

namespace holdfast {

std::vector<int> eliminationRanks(Index unknownCount, const std::vector<Triangle>& triangles)
{
  const SparseMatrix edges = stiffness(unknownCount, unitEdgeWeights(triangles));
  Graph graph;
  graph.start.reserve(static_cast<std::size_t>(unknownCount) + 1);
  graph.neighbour.reserve(static_cast<std::size_t>(edges.nonZeros()));
  for (Index v = 0; v < unknownCount; ++v) {
    for (SparseMatrix::InnerIterator entry(edges, v); entry; ++entry)
      if (entry.row() != v) graph.neighbour.push_back(static_cast<int>(entry.row()));
    graph.degree.push_back(static_cast<int>(graph.neighbour.size()) - graph.start.back());
    graph.start.push_back(static_cast<int>(graph.neighbour.size()));
  }
  graph.edgeWeight.assign(graph.neighbour.size(), 1);
  graph.weight.assign(graph.degree.size(), 1);
  return nestedDissection(std::move(graph));
}

SparseMatrix orderedColumns(const SparseMatrix& Q, const std::vector<int>& ranks)
{
  if (ranks.empty()) return Q;
  std::vector<int> last(static_cast<std::size_t>(Q.cols()), -1);
  for (Index k = 0; k < Q.cols(); ++k)
    for (SparseMatrix::InnerIterator entry(Q, k); entry; ++entry) last[k] = std::max(last[k], ranks[entry.row()]);
  std::vector<int> order(last.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](int k) { return last[k]; });
  return assembled<SparseMatrix>(Q.rows(), Q.cols(), [&](Index k, ColumnSum& sum) { sum.addColumn(Q, order[k]); });
}

}  // namespace holdfast
