#include "spot.h"

#include <algorithm>
#include <array>

#include "write.h"

namespace holdfast::generate {
namespace {

constexpr std::array<double, 3> kFaceWeights{0.25, 0.25, 0.5};
constexpr double kEdgeShare = 0.25;

template <typename Candidates, typename Middle>
auto nearest(const Candidates& candidates, const Vector3& place, const Middle& middle)
{
  return *std::ranges::min_element(candidates, {},
                                   [&](const auto& candidate) { return (middle(candidate) - place).norm(); });
}

std::vector<Index> idsBelow(std::size_t count)
{
  std::vector<Index> result;
  for (Index id = 0; id < static_cast<Index>(count); ++id) result.push_back(id);
  return result;
}

Spot nearestVertex(const GroupedMesh& mesh, const Vector3& place)
{
  const Index vertex =
      nearest(idsBelow(mesh.points.size()), place, [&](Index id) -> Vector3 { return mesh.points[id]; });
  return {VertexSpot{vertex}, mesh.points[vertex]};
}

Spot nearestEdge(const GroupedMesh& mesh, const Vector3& place)
{
  std::vector<EdgeSpot> edges;
  for (const auto& [a, b, c] : mesh.triangles) edges.insert(edges.end(), {{a, b}, {b, c}, {c, a}});
  const EdgeSpot edge =
      nearest(edges, place, [&](const EdgeSpot& e) -> Vector3 { return (mesh.points[e.i] + mesh.points[e.j]) / 2; });
  return {edge, rounded(Vector3(kEdgeShare * mesh.points[edge.i] + (1 - kEdgeShare) * mesh.points[edge.j]))};
}

Spot nearestFace(const GroupedMesh& mesh, const Vector3& place)
{
  const auto weighted = [&](Index face, const std::array<double, 3>& weights) {
    Vector3 sum = Vector3::Zero();
    for (std::size_t k = 0; k < 3; ++k) sum += weights[k] * mesh.points[mesh.triangles[face][k]];
    return sum;
  };
  constexpr std::array<double, 3> kEqual{1.0 / 3, 1.0 / 3, 1.0 / 3};
  const Index face = nearest(idsBelow(mesh.triangles.size()), place, [&](Index id) { return weighted(id, kEqual); });
  return {FaceSpot{face}, rounded(weighted(face, kFaceWeights))};
}

std::string textOf(const VertexSpot& at, const Vector3& /*rest*/)
{
  return "{\"vertex\": " + std::to_string(at.vertex) + "}";
}

std::string textOf(const EdgeSpot& at, const Vector3& /*rest*/)
{
  return "{\"edge\": [" + std::to_string(at.i) + ", " + std::to_string(at.j) + "], \"t\": " + numberText(kEdgeShare) +
         "}";
}

std::string textOf(const FaceSpot& at, const Vector3& /*rest*/)
{
  return "{\"face\": " + std::to_string(at.face) + ", \"weights\": [" + numberText(kFaceWeights[0]) + ", " +
         numberText(kFaceWeights[1]) + ", " + numberText(kFaceWeights[2]) + "]}";
}

std::string textOf(const NearSpot& /*at*/, const Vector3& rest)
{
  return "{\"near\": [" + numberText(rest.x()) + ", " + numberText(rest.y()) + ", " + numberText(rest.z()) + "]}";
}

}  // namespace

Spot findSpot(const GroupedMesh& mesh, SpotKind kind, const Vector3& place)
{
  if (kind == SpotKind::kVertex) return nearestVertex(mesh, place);
  if (kind == SpotKind::kEdge) return nearestEdge(mesh, place);
  const Spot face = nearestFace(mesh, place);
  return kind == SpotKind::kFace ? face : Spot{NearSpot{}, face.rest};
}

std::string atText(const Spot& spot)
{
  return std::visit([&](const auto& where) { return textOf(where, spot.rest); }, spot.where);
}

}  // namespace holdfast::generate
