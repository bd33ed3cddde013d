#include "holdfast/mesh/solver_mesh.h"

#include <holdfast/base/disjoint_sets.h>
#include <holdfast/geometry/bounding_box.h>

namespace holdfast {
namespace {

void findComponents(SolverMesh& mesh)
{
  DisjointSets sets(mesh.unknownCount());
  std::vector<bool> isUsed(static_cast<std::size_t>(mesh.unknownCount()), false);
  for (const Triangle& triangle : mesh.triangles) {
    sets.unite(triangle[0], triangle[1]);
    sets.unite(triangle[0], triangle[2]);
    for (const Index v : triangle) isUsed[v] = true;
  }
  mesh.componentOf.assign(isUsed.size(), -1);
  for (Index v = 0; v < mesh.unknownCount(); ++v) {
    if (!isUsed[v]) continue;
    const Index first = sets.find(v);
    mesh.componentOf[v] = first == v ? mesh.componentCount++ : mesh.componentOf[first];
  }
}

void addTriangles(SolverMesh& mesh, const Triangulation& triangulation)
{
  for (std::size_t t = 0; t < triangulation.triangles.size(); ++t) {
    Triangle triangle = triangulation.triangles[t];
    for (Index& v : triangle) v = mesh.weld.unknownOf[v];
    if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0]) continue;
    mesh.triangles.push_back(triangle);
    mesh.faceOf.push_back(triangulation.faceOf[t]);
  }
}

}  // namespace

SolverMesh makeSolverMesh(const Mesh& mesh, const Triangulation& triangulation)
{
  SolverMesh result;
  result.weld = weldOpenEdges(mesh.positions, triangulation.triangles);
  result.rest.resize(result.weld.unknownCount, 3);
  for (Index u = 0; u < result.weld.unknownCount; ++u)
    result.rest.row(u) = mesh.positions.row(result.weld.firstVertexOf[u]);
  result.diagonal = boundingBoxDiagonal(mesh.positions);
  addTriangles(result, triangulation);
  findComponents(result);
  return result;
}

Positions restInDiagonals(const SolverMesh& mesh)
{
  Positions rest = mesh.rest;
  if (rest.rows() > 0) rest.rowwise() -= mesh.rest.row(0);
  if (mesh.diagonal > 0) rest /= mesh.diagonal;
  return rest;
}

std::vector<Index> componentOfVertices(const SolverMesh& solverMesh)
{
  std::vector<Index> result;
  result.reserve(solverMesh.weld.unknownOf.size());
  for (const Index unknown : solverMesh.weld.unknownOf) result.push_back(solverMesh.componentOf[unknown]);
  return result;
}

}  // namespace holdfast
