#include "holdfast/operators/laplacian.h"

#include <holdfast/mesh/edges.h>

namespace holdfast {

std::vector<EdgeWeight> unitEdgeWeights(const std::vector<Triangle>& triangles)
{
  std::vector<EdgeWeight> weights;
  forEachEdge(sortedHalfEdges(triangles), [&](std::span<const HalfEdge> edge) {
    weights.push_back({edge[0].a, edge[0].b, 1});
  });
  return weights;
}

std::vector<EdgeWeight> cotangentEdgeWeights(const std::vector<Triangle>& triangles,
                                             const std::vector<CornerCotangents>& cotangents)
{
  std::vector<EdgeWeight> weights;
  forEachEdge(sortedHalfEdges(triangles), [&](std::span<const HalfEdge> edge) {
    double sum = 0;
    for (const HalfEdge& half : edge) sum += cotangents[half.triangle][(half.side + 2) % 3];
    weights.push_back({edge[0].a, edge[0].b, sum});
  });
  return weights;
}

SparseMatrix stiffness(Index n, const std::vector<EdgeWeight>& weights)
{
  std::vector<Eigen::Triplet<double, int>> entries;
  entries.reserve(2 * weights.size() + static_cast<std::size_t>(n));
  Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(n);
  for (const auto& [i, j, weight] : weights) {
    entries.emplace_back(static_cast<int>(i), static_cast<int>(j), -weight);
    entries.emplace_back(static_cast<int>(j), static_cast<int>(i), -weight);
    diagonal[i] += weight;
    diagonal[j] += weight;
  }
  for (Index i = 0; i < n; ++i) entries.emplace_back(static_cast<int>(i), static_cast<int>(i), diagonal[i]);
  SparseMatrix result(n, n);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

}  // namespace holdfast
