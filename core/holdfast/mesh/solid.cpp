#include "holdfast/mesh/solid.h"

#include <algorithm>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include <holdfast/mesh/edges.h>

namespace holdfast {
namespace {

bool isClosed(const SolverMesh& mesh)
{
  bool isClosed = true;
  forEachEdge(sortedHalfEdges(mesh.triangles), [&](std::span<const HalfEdge> edge) {
    isClosed = isClosed && edge.size() == 2 && edge[0].isForward != edge[1].isForward;
  });
  return isClosed;
}

/// Six times the volume of each connected part, in cubes of the diagonal.
std::vector<double> volumes(const SolverMesh& mesh)
{
  const Positions rest = restInDiagonals(mesh);
  const auto at = [&](Index unknown) -> Vector3 { return rest.row(unknown).transpose(); };
  std::vector<double> volumes(static_cast<std::size_t>(mesh.componentCount), 0.0);
  for (const auto& [a, b, c] : mesh.triangles) volumes[mesh.componentOf[a]] += at(a).dot(at(b).cross(at(c)));
  return volumes;
}

}  // namespace

bool isSolid(const SolverMesh& mesh)
{
  if (!isClosed(mesh)) return false;
  const std::vector<double> found = volumes(mesh);
  return std::all_of(found.begin(), found.end(), [](double volume) { return volume > 0; });
}

}  // namespace holdfast
