#include "holdfast/mesh/stated_places.h"

namespace holdfast {
namespace {

std::vector<char> verticesOfSurface(const Mesh& mesh)
{
  std::vector<char> isUsed(static_cast<std::size_t>(mesh.vertexCount()), 0);
  for (Index f = 0; f < mesh.faces.size(); ++f)
    if (mesh.faces.isSurface(f))
      for (const Index v : mesh.faces[f]) isUsed[v] = 1;
  return isUsed;
}

}  // namespace

std::vector<Index> facesWithoutSurface(const Polygons& faces)
{
  std::vector<Index> result;
  for (Index f = 0; f < faces.size(); ++f)
    if (!faces.isSurface(f)) result.push_back(f);
  return result;
}

Mesh surfaceOf(const Mesh& mesh)
{
  Mesh surface{mesh.positions, {}};
  surface.faces.reserve(mesh.faces.size(), mesh.faces.cornerCount());
  for (Index f = 0; f < mesh.faces.size(); ++f)
    if (mesh.faces.isSurface(f)) surface.faces.add(mesh.faces[f]);
  return surface;
}

NonFiniteVertices nonFiniteVertices(const Mesh& mesh)
{
  NonFiniteVertices result;
  if (mesh.positions.allFinite()) return result;
  const std::vector<char> isUsed = verticesOfSurface(mesh);
  for (Index v = 0; v < mesh.vertexCount(); ++v)
    if (!mesh.positions.row(v).allFinite()) (isUsed[v] != 0 ? result.ofSurface : result.unused).push_back(v);
  return result;
}

Positions withStatedPlaces(const Positions& stated, Positions positions)
{
  for (Index v = 0; v < stated.rows(); ++v)
    if (!stated.row(v).allFinite()) positions.row(v) = stated.row(v);
  return positions;
}

}  // namespace holdfast
