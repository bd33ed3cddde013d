#include "holdfast/widgets/rotation_sphere/placed_rotations.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

namespace holdfast {
namespace {

std::uint64_t cellOf(const Vector3& place, double side)
{
  constexpr double kMiddle = 1 << 20;
  std::uint64_t cell = 0;
  for (const double coordinate : place)
    cell = cell << 21U |
           static_cast<std::uint64_t>(std::clamp(std::floor(coordinate / side) + kMiddle, 1.0, 2 * kMiddle - 1));
  return cell;
}

std::vector<Index> firstOfCells(const std::vector<Vector3>& places, const std::vector<Index>& among, double side)
{
  std::vector<std::pair<std::uint64_t, Index>> cells;
  for (const Index place : among) cells.emplace_back(cellOf(places[place], side), place);
  std::sort(cells.begin(), cells.end());
  const auto isSame = [](const auto& a, const auto& b) { return a.first == b.first; };
  cells.erase(std::unique(cells.begin(), cells.end(), isSame), cells.end());
  std::vector<Index> first;
  for (const auto& [cell, place] : cells) first.push_back(place);
  std::sort(first.begin(), first.end());
  return first;
}

// In radii: points that are nearer to one another than a pixel of a sphere that is shown several times as large as the
// panel hide one another.
constexpr double kFinestCell = 1.0 / 4096;

}  // namespace

std::vector<Index> thinnedPlaces(const std::vector<Vector3>& places, Index most, double finest)
{
  std::vector<Index> chosen(places.size());
  std::iota(chosen.begin(), chosen.end(), Index{0});
  for (double side = finest; static_cast<Index>(chosen.size()) > most; side *= 2)
    chosen = firstOfCells(places, chosen, side);
  return chosen;
}

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
