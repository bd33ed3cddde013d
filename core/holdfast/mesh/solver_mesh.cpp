#include "holdfast/mesh/solver_mesh.h"

#include <algorithm>
#include <array>
#include <compare>
#include <utility>

#include <holdfast/base/disjoint_sets.h>
#include <holdfast/geometry/bounding_box.h>
#include <holdfast/mesh/edges.h>

namespace holdfast {
namespace {

using Place = std::array<double, 3>;

Place placeOf(const Positions& positions, Index v)
{
  return {positions(v, 0), positions(v, 1), positions(v, 2)};
}

/// An edge of one triangle only, its ends ordered by place.
struct OpenEdge {
  Place low;
  Place high;
  Index lowVertex;
  Index highVertex;

  friend auto operator<=>(const OpenEdge&, const OpenEdge&) = default;
};

OpenEdge openEdge(const Positions& positions, Index a, Index b)
{
  Place low = placeOf(positions, a);
  Place high = placeOf(positions, b);
  if (high < low) {
    std::swap(low, high);
    std::swap(a, b);
  }
  return {low, high, a, b};
}

std::vector<OpenEdge> openEdges(const Positions& positions, const std::vector<Triangle>& triangles)
{
  std::vector<OpenEdge> open;
  forEachEdge(sortedHalfEdges(triangles), [&](std::span<const HalfEdge> edge) {
    if (edge.size() == 1) open.push_back(openEdge(positions, edge[0].a, edge[0].b));
  });
  // An edge without length says nothing about which of the vertices at its place belong together.
  std::erase_if(open, [](const OpenEdge& edge) { return edge.low == edge.high; });
  std::sort(open.begin(), open.end());
  return open;
}

Weld numbered(DisjointSets& sets, Index vertexCount)
{
  Weld weld;
  weld.unknownOf.resize(static_cast<std::size_t>(vertexCount));
  for (Index v = 0; v < vertexCount; ++v) {
    const Index first = sets.find(v);  // the smallest of its set, so it has its number already unless it is v
    if (first == v) weld.firstVertexOf.push_back(v);
    weld.unknownOf[v] = first == v ? weld.unknownCount++ : weld.unknownOf[first];
  }
  return weld;
}

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
  result.rest = mesh.positions(result.weld.firstVertexOf, Eigen::all);
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

Weld weldOpenEdges(const Positions& positions, const std::vector<Triangle>& triangles)
{
  DisjointSets sets(positions.rows());
  const std::vector<OpenEdge> open = openEdges(positions, triangles);
  for (std::size_t k = 1; k < open.size(); ++k)
    if (open[k].low == open[k - 1].low && open[k].high == open[k - 1].high) {
      sets.unite(open[k].lowVertex, open[k - 1].lowVertex);
      sets.unite(open[k].highVertex, open[k - 1].highVertex);
    }
  return numbered(sets, positions.rows());
}

}  // namespace holdfast
