#include "bench/paper/shape_measures.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <holdfast/constraints/selector.h>
#include <holdfast/operators/laplacian.h>
#include <holdfast/surface/surface_locator.h>

namespace holdfast::paper {

Spread spreadOf(const std::vector<double>& values)
{
  Spread spread;
  for (const double value : values) {
    spread.rms += value * value / static_cast<double>(values.size());
    spread.largest = std::max(spread.largest, std::abs(value));
  }
  spread.rms = std::sqrt(spread.rms);
  return spread;
}

Spread distanceBetween(const Model& model, const Positions& shape, const std::vector<Index>& vertices,
                       const Model& other, const Positions& otherShape)
{
  const SurfaceLocator locator = other.locator();
  std::vector<double> distances;
  for (const Index v : vertices) {
    const SurfacePoint point = locator.closestTo(model.mesh.positions.row(v)).point;
    distances.push_back((positionOf(point, otherShape) - shape.row(v).transpose()).norm());
  }
  return spreadOf(distances);
}

Spread stretchOf(const Model& model, const Positions& shape, const std::vector<Index>& vertices)
{
  std::vector<bool> isChosen(model.mesh.vertexCount());
  for (const Index v : vertices) isChosen[v] = true;
  const auto lengthIn = [](const Positions& positions, const EdgeWeight& edge) {
    return (positions.row(edge.i) - positions.row(edge.j)).norm();
  };
  std::vector<double> changes;
  for (const EdgeWeight& edge : unitEdgeWeights(model.triangulation.triangles))
    if (isChosen[edge.i] && isChosen[edge.j])
      changes.push_back(lengthIn(shape, edge) / lengthIn(model.mesh.positions, edge) - 1);
  return spreadOf(changes);
}

std::vector<Index> allVertices(const Model& model)
{
  std::vector<Index> all(model.mesh.vertexCount());
  std::iota(all.begin(), all.end(), Index{0});
  return all;
}

std::vector<Index> verticesOf(const Model& model, const Selection& selection)
{
  return Selector(model.mesh, model.solverMesh, model.locator()).select(selection, {"experiment", 0, ""});
}

}  // namespace holdfast::paper
