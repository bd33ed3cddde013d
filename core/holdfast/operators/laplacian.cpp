#include "holdfast/operators/laplacian.h"

#include <holdfast/mesh/edges.h>

namespace holdfast {

namespace {

template <class WeightOf>
std::vector<EdgeWeight> edgeWeights(const std::vector<Triangle>& triangles, const WeightOf& weightOf)
{
  const std::vector<HalfEdge> halfEdges = sortedHalfEdges(triangles);
  std::vector<EdgeWeight> weights;
  weights.reserve(halfEdges.size() / 2);
  forEachEdge(halfEdges, [&](std::span<const HalfEdge> edge) {
    weights.push_back({edge[0].a, edge[0].b, weightOf(edge)});
  });
  return weights;
}

}  // namespace

std::vector<EdgeWeight> unitEdgeWeights(const std::vector<Triangle>& triangles)
{
  return edgeWeights(triangles, [](std::span<const HalfEdge> /*edge*/) { return 1.0; });
}

std::vector<EdgeWeight> cotangentEdgeWeights(const std::vector<Triangle>& triangles,
                                             const std::vector<CornerCotangents>& cotangents)
{
  return edgeWeights(triangles, [&](std::span<const HalfEdge> edge) {
    double sum = 0;
    for (const HalfEdge& half : edge) sum += cotangents[half.triangle][(half.side + 2) % 3];
    return sum;
  });
}

SparseMatrix stiffness(Index n, const std::vector<EdgeWeight>& weights)
{
  SparseMatrix result(n, n);
  int* const start = result.outerIndexPtr();
  Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(n);
  for (const auto& [i, j, weight] : weights) {
    ++start[i + 1];
    ++start[j + 1];
    diagonal[i] += weight;
    diagonal[j] += weight;
  }
  for (Index i = 0; i < n; ++i) start[i + 1] += start[i] + 1;
  result.resizeNonZeros(start[n]);
  std::vector<int> next(start, start + n);
  const auto append = [&](Index row, Index column, double value) {
    result.innerIndexPtr()[next[column]] = static_cast<int>(row);
    result.valuePtr()[next[column]++] = value;
  };
  // Ascending in every column: the entries of smaller rows, the diagonal, and those of larger rows.
  auto edge = weights.begin();
  for (Index i = 0; i < n; ++i) {
    append(i, i, diagonal[i]);
    for (; edge != weights.end() && edge->i == i; ++edge) {
      append(edge->j, i, -edge->weight);
      append(i, edge->j, -edge->weight);
    }
  }
  return result;
}

}  // namespace holdfast
