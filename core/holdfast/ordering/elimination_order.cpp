#include "holdfast/ordering/elimination_order.h"

#include <algorithm>
#include <numeric>

#include <holdfast/matrices/sparse_products.h>
#include <holdfast/mesh/edges.h>
#include <holdfast/ordering/nested_dissection.h>

namespace holdfast {

namespace {

/// Vertices and edges of the mesh, neighbours ascending.
Graph graphOf(Index unknownCount, const std::vector<Triangle>& triangles)
{
  const std::vector<HalfEdge> halfEdges = sortedHalfEdges(triangles);
  Graph graph;
  graph.degree.resize(static_cast<std::size_t>(unknownCount));
  forEachEdge(halfEdges, [&](std::span<const HalfEdge> edge) {
    ++graph.degree[edge[0].a];
    ++graph.degree[edge[0].b];
  });
  graph.start.resize(graph.degree.size() + 1);
  std::partial_sum(graph.degree.begin(), graph.degree.end(), graph.start.begin() + 1);
  graph.neighbour.resize(static_cast<std::size_t>(graph.start.back()));
  std::vector<int> next(graph.start.begin(), graph.start.end() - 1);
  forEachEdge(halfEdges, [&](std::span<const HalfEdge> edge) {
    graph.neighbour[next[edge[0].a]++] = edge[0].b;
    graph.neighbour[next[edge[0].b]++] = edge[0].a;
  });
  graph.edgeWeight.assign(graph.neighbour.size(), 1);
  graph.weight.assign(graph.degree.size(), 1);
  return graph;
}

}  // namespace

std::vector<int> eliminationRanks(Index unknownCount, const std::vector<Triangle>& triangles)
{
  return nestedDissection(graphOf(unknownCount, triangles));
}

std::vector<int> ascending(const std::vector<int>& keys, int end)
{
  std::vector<int> next(static_cast<std::size_t>(end) + 2, 0);
  for (const int key : keys) ++next[key + 2];
  std::partial_sum(next.begin(), next.end(), next.begin());
  std::vector<int> order(keys.size());
  for (std::size_t k = 0; k < keys.size(); ++k) order[next[keys[k] + 1]++] = static_cast<int>(k);
  return order;
}

SparseMatrix orderedColumns(const SparseMatrix& Q, const std::vector<int>& ranks)
{
  if (ranks.empty()) return Q;
  std::vector<int> last(static_cast<std::size_t>(Q.cols()), -1);
  for (Index k = 0; k < Q.cols(); ++k)
    for (SparseMatrix::InnerIterator entry(Q, k); entry; ++entry) last[k] = std::max(last[k], ranks[entry.row()]);
  const std::vector<int> order = ascending(last, static_cast<int>(ranks.size()));
  return assembled<SparseMatrix>(Q.rows(), Q.cols(), [&](Index k, ColumnSum& sum) { sum.addColumn(Q, order[k]); });
}

}  // namespace holdfast
