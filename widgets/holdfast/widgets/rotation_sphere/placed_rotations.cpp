#include "holdfast/widgets/rotation_sphere/placed_rotations.h"

#include <holdfast/widgets/rotation_sphere/thinned_places.h>

namespace holdfast {
namespace {

// In radii: points that are nearer to one another than a pixel of a sphere that is shown several times as large as the
// panel hide one another.
constexpr double kFinestCell = 1.0 / 4096;

}  // namespace

SphereVertices sphereVertices(const Model& model)
{
  const SolverMesh& mesh = model.solverMesh;
  SphereVertices vertices;
  std::vector<Index> pointOfUnknown(mesh.unknownCount(), -1);
  for (Index u = 0; u < mesh.unknownCount(); ++u) {
    if (mesh.componentOf[u] < 0) continue;
    pointOfUnknown[u] = static_cast<Index>(vertices.vertexOf.size());
    vertices.vertexOf.push_back(mesh.weld.firstVertexOf[u]);
    vertices.unknownOf.push_back(u);
  }
  for (Index v = 0; v < model.mesh.vertexCount(); ++v)
    vertices.pointOf.push_back(pointOfUnknown[mesh.weld.unknownOf[v]]);
  return vertices;
}

std::shared_ptr<const PlacedRotations> placeRotations(const Model& model, const DeformResult& deformation,
                                                      const std::shared_ptr<const PlacedRotations>& before)
{
  auto placed = std::make_shared<PlacedRotations>();
  placed->vertices = before ? before->vertices : std::make_shared<const SphereVertices>(sphereVertices(model));
  placed->boundary = boundaryRotations(deformation);
  placed->frame = sphereFrame(placed->boundary, before ? before->frame : SphereFrame{});
  for (const Index unknown : placed->vertices->unknownOf)
    placed->places.push_back(spherePlace(placed->frame, deformation.rotations.row(unknown).transpose()));
  placed->drawn = thinnedPlaces(placed->places, kMostSpherePoints, kFinestCell);
  return placed;
}

}  // namespace holdfast
