#include "holdfast/mesh/triangulation.h"

#include <algorithm>
#include <span>

#include <holdfast/mesh/ear_clipping_internal.h>

namespace holdfast {
namespace {

/// The corners seen from the first one, no coordinate beyond 1: products of areas stay within the range of doubles.
std::vector<Vector3> inUnitsOfItsSize(const Positions& positions, std::span<const Index> face)
{
  std::vector<Vector3> polygon;
  polygon.reserve(face.size());
  double size = 0;
  for (const Index v : face) {
    polygon.emplace_back(positions.row(v) - positions.row(face[0]));
    size = std::max(size, polygon.back().cwiseAbs().maxCoeff());
  }
  if (size > 0)
    for (Vector3& corner : polygon) corner /= size;
  return polygon;
}

std::vector<std::array<Index, 3>> cornersOfTriangles(const Positions& positions, std::span<const Index> face)
{
  if (face.size() == 3) return {{0, 1, 2}};
  return clipEars(inUnitsOfItsSize(positions, face));
}

}  // namespace

Triangulation triangulate(const Mesh& mesh)
{
  Triangulation result;
  const auto expected = static_cast<std::size_t>(mesh.faces.cornerCount() - 2 * mesh.faces.size());
  result.triangles.reserve(expected);
  result.corners.reserve(expected);
  result.faceOf.reserve(expected);
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    const auto face = mesh.faces[f];
    for (const auto& corners : cornersOfTriangles(mesh.positions, face)) {
      result.triangles.push_back({face[corners[0]], face[corners[1]], face[corners[2]]});
      result.corners.push_back(corners);
      result.faceOf.push_back(f);
    }
  }
  return result;
}

}  // namespace holdfast
