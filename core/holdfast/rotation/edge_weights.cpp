#include "holdfast/rotation/edge_weights.h"

#include <algorithm>
#include <utility>

namespace holdfast {
namespace {

std::vector<EdgeWeight> guardedWeights(const SolverMesh& mesh, std::vector<CornerCotangents> cotangents)
{
  for (CornerCotangents& corners : cotangents) corners = guarded(corners);
  std::vector<EdgeWeight> weights = cotangentEdgeWeights(mesh.triangles, cotangents);
  for (EdgeWeight& edge : weights) edge.weight = std::max(edge.weight, kRotationWeightFloor);
  return weights;
}

}  // namespace

std::vector<EdgeWeight> rotationEdgeWeights(const SolverMesh& mesh, Weights weights)
{
  if (weights == Weights::Uniform) return unitEdgeWeights(mesh.triangles);
  std::vector<CornerCotangents> cotangents = cornerCotangents(restInDiagonals(mesh), mesh.triangles);
  if (weights == Weights::CotangentPaper) return cotangentEdgeWeights(mesh.triangles, cotangents);
  return guardedWeights(mesh, std::move(cotangents));
}

}  // namespace holdfast
