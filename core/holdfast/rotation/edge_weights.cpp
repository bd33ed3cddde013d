#include "holdfast/rotation/edge_weights.h"

#include <utility>

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

RotationWeights guardedWeights(const SolverMesh& mesh, std::vector<CornerCotangents> cotangents)
{
  RotationWeights weights;
  weights.capped = guardAll(cotangents, mesh.triangles);
  weights.edges = cotangentEdgeWeights(mesh.triangles, cotangents);
  weights.floored = floorWeights(weights.edges);
  return weights;
}

}  // namespace

RotationWeights rotationEdgeWeights(const SolverMesh& mesh, Weights weights)
{
  if (weights == Weights::Uniform) return {unitEdgeWeights(mesh.triangles), {}, {}};
  std::vector<CornerCotangents> cotangents = cornerCotangents(restInDiagonals(mesh), mesh.triangles);
  if (weights == Weights::CotangentPaper) return {cotangentEdgeWeights(mesh.triangles, cotangents), {}, {}};
  return guardedWeights(mesh, std::move(cotangents));
}

}  // namespace holdfast
