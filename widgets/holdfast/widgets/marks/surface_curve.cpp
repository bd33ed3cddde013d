#include "holdfast/widgets/marks/surface_curve.h"

#include <algorithm>
#include <vector>

#include <holdfast/surface/curve_region.h>

namespace holdfast {
namespace {

/// Whether edges join all of these unknowns.
bool areConnected(const std::vector<Index>& unknowns, const SolverMesh& mesh)
{
  return std::all_of(unknowns.begin(), unknowns.end(), [&](Index unknown) {
    return mesh.componentOf[unknown] >= 0 && mesh.componentOf[unknown] == mesh.componentOf[unknowns.front()];
  });
}

}  // namespace

Positions curveThrough(std::span<const Index> vertices, const EdgeGraph& graph, const SolverMesh& mesh,
                       const Positions& positions)
{
  std::vector<Index> places;
  for (const Index vertex : vertices)
    // Clicking a place twice does not lead the curve anywhere.
    if (const Index unknown = mesh.weld.unknownOf[vertex]; places.empty() || places.back() != unknown)
      places.push_back(unknown);
  if (places.empty() || !areConnected(places, mesh)) return Positions(0, 3);
  std::vector<Index> curve = places.size() == 1 ? places : closedCurve(graph, places);
  curve.push_back(curve.front());
  Positions line(static_cast<Index>(curve.size()), 3);
  for (Index k = 0; k < line.rows(); ++k) line.row(k) = positions.row(mesh.weld.firstVertexOf[curve[k]]);
  return line;
}

}  // namespace holdfast
