#include "holdfast/mesh/solver_mesh.h"

#include <bit>

#include <holdfast/geometry/bounding_box.h>
#include <holdfast/matrices/largest_size.h>
#include <holdfast/mesh/edges.h>
#include <holdfast/mesh/near_pairs.h>
#include <holdfast/numbers/disjoint_sets.h>

namespace holdfast {
namespace {

Weld numbered(DisjointSets& sets, Index vertexCount)
{
  Weld weld;
  weld.unknownOf.resize(static_cast<std::size_t>(vertexCount));
  for (Index v = 0; v < vertexCount; ++v) {
    const Index first = sets.find(v);  // the smallest of its set, so it has its number already unless it is v
    if (first == v) weld.firstVertexOf.push_back(static_cast<int>(v));
    weld.unknownOf[v] = first == v ? static_cast<int>(weld.unknownCount++) : weld.unknownOf[first];
  }
  weld.firstVertexOf.shrink_to_fit();
  return weld;
}

/// Makes one place of those of ends of `open` edges that lie within `tolerance` of one another.
void joinNearPlaces(std::vector<int>& placeOf, const std::vector<HalfEdge>& open, const Positions& positions,
                    double tolerance)
{
  std::vector<int> ends;
  for (const HalfEdge& half : open) ends.insert(ends.end(), {placeOf[half.a], placeOf[half.b]});
  std::ranges::sort(ends);
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  DisjointSets near(positions.rows());
  for (const auto& [a, b] : nearPairs(positions, ends, tolerance)) near.unite(a, b);
  for (int& place : placeOf) place = static_cast<int>(near.find(place));
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
    mesh.componentOf[v] = first == v ? static_cast<int>(mesh.componentCount++) : mesh.componentOf[first];
  }
}

void addTriangles(SolverMesh& mesh, const Triangulation& triangulation)
{
  mesh.triangles.reserve(triangulation.triangles.size());
  mesh.faceOf.reserve(triangulation.triangles.size());
  for (std::size_t t = 0; t < triangulation.triangles.size(); ++t) {
    Triangle triangle = triangulation.triangles[t];
    for (int& v : triangle) v = mesh.weld.unknownOf[v];
    if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0]) continue;
    mesh.triangles.push_back(triangle);
    mesh.faceOf.push_back(triangulation.faceOf[t]);
  }
}

}  // namespace

SolverMesh makeSolverMesh(const Mesh& mesh, const Triangulation& triangulation, double weldTolerance,
                          std::vector<Index> withoutPlace)
{
  SolverMesh result;
  result.withoutPlace = std::move(withoutPlace);
  result.weld = weldOpenEdges(mesh.positions, triangulation.triangles, weldTolerance);
  result.rest = mesh.positions(result.weld.firstVertexOf, Eigen::all);
  result.diagonal = boundingBoxDiagonal(mesh.positions);
  result.largestCoordinate = largestSize(result.rest);
  addTriangles(result, triangulation);
  findComponents(result);
  return result;
}

Positions restOfVertices(const SolverMesh& mesh)
{
  return mesh.rest(mesh.weld.unknownOf, Eigen::all);
}

Positions restInDiagonals(const SolverMesh& mesh)
{
  Positions rest = mesh.rest;
  if (rest.rows() > 0) rest.rowwise() -= mesh.rest.row(0);
  if (mesh.diagonal > 0) rest /= mesh.diagonal;
  return rest;
}

std::vector<int> componentOfVertices(const SolverMesh& solverMesh)
{
  std::vector<int> result;
  result.reserve(solverMesh.weld.unknownOf.size());
  for (const Index unknown : solverMesh.weld.unknownOf) result.push_back(solverMesh.componentOf[unknown]);
  return result;
}

std::vector<int> firstAtPlaces(const Positions& positions)
{
  // A table by hashes, at most half full; the next entry is free or tried where one is taken.
  std::vector<int> table(2 * std::bit_ceil(static_cast<std::size_t>(positions.rows())), -1);
  std::vector<int> first(static_cast<std::size_t>(positions.rows()));
  for (int v = 0; v < static_cast<int>(first.size()); ++v) {
    std::uint64_t hash = 0;
    for (const double x : positions.row(v)) {
      hash = (hash ^ std::bit_cast<std::uint64_t>(x + 0.0)) * 0x9E3779B97F4A7C15U;  // -0 becomes 0
      hash ^= hash >> 32U;
    }
    std::size_t entry = hash & (table.size() - 1);
    while (table[entry] >= 0 && positions.row(table[entry]) != positions.row(v))
      entry = (entry + 1) & (table.size() - 1);
    if (table[entry] < 0) table[entry] = v;
    first[v] = table[entry];
  }
  return first;
}

Weld weldOpenEdges(const Positions& positions, const std::vector<Triangle>& triangles, double tolerance)
{
  std::vector<HalfEdge> open;
  forEachEdge(sortedHalfEdges(triangles), [&](std::span<const HalfEdge> edge) {
    if (edge.size() == 1) open.push_back(edge[0]);
  });
  DisjointSets sets(positions.rows());
  if (open.empty()) return numbered(sets, positions.rows());
  std::vector<int> placeOf = firstAtPlaces(positions);
  if (tolerance > 0) joinNearPlaces(placeOf, open, positions, tolerance);
  // Edges between places, as triangles that go there and back. Those without length are left out: they do not say which
  // of the vertices at their place belong together.
  std::vector<Triangle> overPlaces;
  overPlaces.reserve(open.size());
  for (const auto& [a, b, triangle, side, isForward] : open) overPlaces.push_back({placeOf[a], placeOf[b], placeOf[b]});
  const auto endOf = [&](const HalfEdge& half, bool isLow) {
    const HalfEdge& edge = open[half.triangle];
    return (half.side == 0) == (half.isForward == isLow) ? edge.a : edge.b;
  };
  forEachEdge(sortedHalfEdges(overPlaces), [&](std::span<const HalfEdge> edge) {
    for (const HalfEdge& half : edge)
      for (const bool isLow : {true, false}) sets.unite(endOf(edge[0], isLow), endOf(half, isLow));
  });
  Weld weld = numbered(sets, positions.rows());
  for (Index v = 0; v < positions.rows() && tolerance > 0 && !weld.joinsApart; ++v)
    weld.joinsApart = positions.row(v) != positions.row(weld.firstVertexOf[weld.unknownOf[v]]);
  return weld;
}

}  // namespace holdfast
