#include "holdfast/rotation/edge_weights.h"

namespace holdfast {
namespace {

/// Raises weights below the floor; returns the ends of the edges that were negative. Weights of about 0, as across the
/// right angles of a grid, are raised without a word.
std::vector<Index> floorWeights(std::vector<EdgeWeight>& edges)
{
  std::vector<Index> ends;
  for (auto& [i, j, weight] : edges) {
    if (weight >= kRotationWeightFloor) continue;
    if (weight < -kRotationWeightFloor) ends.insert(ends.end(), {i, j});
    weight = kRotationWeightFloor;
  }
  return ends;
}

}  // namespace

RotationWeights rotationEdgeWeights(const Operators& operators)
{
  RotationWeights weights;
  weights.edges.reserve(static_cast<std::size_t>(operators.S->nonZeros()) / 2);
  for (int i = 0; i < operators.S->cols(); ++i)
    for (SparseMatrix::InnerIterator entry(*operators.S, i); entry; ++entry)
      if (i < entry.row()) weights.edges.push_back({i, static_cast<int>(entry.row()), -entry.value()});
  if (operators.weights == Weights::Cotangent) {
    weights.capped = operators.clampedCotangents;
    weights.floored = floorWeights(weights.edges);
  }
  return weights;
}

}  // namespace holdfast
