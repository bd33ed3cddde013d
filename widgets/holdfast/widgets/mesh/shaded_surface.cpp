#include "holdfast/widgets/mesh/shaded_surface.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <span>

#include <holdfast/base/disjoint_sets.h>
#include <holdfast/mesh/edges.h>
#include <holdfast/mesh/vertex_normals.h>

namespace holdfast {
namespace {

Vector3 normalOfTriangle(const Model& model, Index triangle)
{
  return unitOrZero(areaVector(model.mesh.positions, model.triangulation.triangles[triangle]));
}

/// Corners are numbered 3 triangle + place.
Index cornerOf(const HalfEdge& half, const std::vector<Triangle>& triangles, Index vertex)
{
  const int side = half.side;
  return 3 * half.triangle + (triangles[half.triangle][side] == vertex ? side : (side + 1) % 3);
}

bool isSmooth(std::span<const HalfEdge> halves, const Model& model)
{
  if (halves.size() != 2 || halves[0].isForward == halves[1].isForward) return false;
  const double cosine = normalOfTriangle(model, halves[0].triangle).dot(normalOfTriangle(model, halves[1].triangle));
  return cosine >= std::cos(kSharpDegrees * std::numbers::pi / 180);
}

/// Numbers the sets of corners in the order of their first corner.
ShadedSurface numberPoints(const Model& model, DisjointSets& corners)
{
  const std::vector<Triangle>& triangles = model.triangulation.triangles;
  ShadedSurface surface;
  std::vector<Index> pointOf(3 * triangles.size(), -1);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    Triangle points{};
    for (int k = 0; k < 3; ++k) {
      Index& point = pointOf[corners.find(3 * static_cast<Index>(t) + k)];
      if (point < 0) {
        point = static_cast<Index>(surface.vertexOf.size());
        surface.vertexOf.push_back(triangles[t][k]);
      }
      points[k] = point;
    }
    surface.triangles.add(points);
  }
  return surface;
}

struct Chain {
  Index edges = 0;
  Index vertices = 0;
  double length = 0;  // model units
};

/// The sharp edges without the short ends of lines that bends of a smooth surface leave where they are just sharp:
/// what is drawn closes a loop, as rims of the smallest holes do, or has some length.
std::vector<HalfEdge> drawnEdges(const std::vector<HalfEdge>& sharp, const SolverMesh& mesh)
{
  DisjointSets sets(mesh.unknownCount());
  for (const HalfEdge& edge : sharp) sets.unite(edge.a, edge.b);
  std::map<Index, Chain> chains;
  std::set<Index> counted;
  for (const HalfEdge& edge : sharp) {
    Chain& chain = chains[sets.find(edge.a)];
    ++chain.edges;
    chain.length += (mesh.rest.row(edge.a) - mesh.rest.row(edge.b)).stableNorm();
    for (const Index vertex : {edge.a, edge.b}) chain.vertices += counted.insert(vertex).second ? 1 : 0;
  }
  std::vector<HalfEdge> drawn;
  for (const HalfEdge& edge : sharp) {
    const Chain& chain = chains[sets.find(edge.a)];
    if (chain.edges >= chain.vertices || chain.length >= kLeastCreaseLength * mesh.diagonal) drawn.push_back(edge);
  }
  return drawn;
}

/// Those of `creases` that are sides of triangles of `surface`.
std::vector<std::array<Index, 2>> creasesOf(const ShadedSurface& surface,
                                            const std::vector<std::array<Index, 2>>& creases, const SolverMesh& mesh)
{
  const auto sideOf = [&](Index a, Index b) {
    const auto [low, high] =
        std::minmax(mesh.weld.unknownOf[surface.vertexOf[a]], mesh.weld.unknownOf[surface.vertexOf[b]]);
    return std::array{low, high};
  };
  std::map<std::array<Index, 2>, bool> isSide;
  // Most sides do not begin where a crease does, and need no search.
  std::vector<char> isAtCrease(static_cast<std::size_t>(mesh.unknownCount()), 0);
  for (const auto& [a, b] : creases) isAtCrease[isSide.emplace(sideOf(a, b), false).first->first[0]] = 1;
  for (Index t = 0; t < surface.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const auto side = sideOf(surface.triangles[t][k], surface.triangles[t][(k + 1) % 3]);
      if (isAtCrease[side[0]] == 0) continue;
      if (const auto found = isSide.find(side); found != isSide.end()) found->second = true;
    }
  std::vector<std::array<Index, 2>> found;
  for (const auto& [a, b] : creases)
    if (isSide.at(sideOf(a, b))) found.push_back({a, b});
  return found;
}

}  // namespace

std::vector<Index> ShadedSurface::pointOf(Index vertexCount) const
{
  std::vector<Index> points(static_cast<std::size_t>(vertexCount), -1);
  for (std::size_t k = vertexOf.size(); k-- > 0;) points[vertexOf[k]] = static_cast<Index>(k);
  return points;
}

ShadedSurface without(const ShadedSurface& surface, const Model& model, const std::vector<char>& isHidden)
{
  ShadedSurface some;
  some.vertexOf = surface.vertexOf;
  std::vector<Index> numberOf(isHidden.size(), -1);
  for (Index t = 0; t < surface.triangles.size(); ++t) {
    if (isHidden[t] != 0) continue;
    numberOf[t] = some.triangles.size();
    some.triangles.add(surface.triangles[t]);
  }
  for (Index t = 0; t < surface.triangles.size(); ++t) {
    if (isHidden[t] != 0) continue;
    Triangle across = surface.across[t];
    for (Index& other : across) other = other < 0 ? -1 : numberOf[other];
    some.across.push_back(across);
  }
  some.creases = creasesOf(some, surface.creases, model.solverMesh);
  return some;
}

ShadedSurface cutAtSharpEdges(const Model& model)
{
  const std::vector<Triangle> triangles = trianglesOverUnknowns(model);
  DisjointSets corners(3 * static_cast<Index>(triangles.size()));
  std::vector<HalfEdge> sharp;
  std::vector<Triangle> across(triangles.size(), {-1, -1, -1});
  forEachEdge(sortedHalfEdges(triangles), [&](std::span<const HalfEdge> halves) {
    if (halves.size() == 2)
      for (const int k : {0, 1}) across[halves[k].triangle][halves[k].side] = halves[1 - k].triangle;
    if (!isSmooth(halves, model)) return sharp.push_back(halves[0]);
    for (const Index vertex : {halves[0].a, halves[0].b})
      corners.unite(cornerOf(halves[0], triangles, vertex), cornerOf(halves[1], triangles, vertex));
  });
  ShadedSurface surface = numberPoints(model, corners);
  surface.across = std::move(across);
  for (const HalfEdge& half : drawnEdges(sharp, model.solverMesh)) {
    const auto points = surface.triangles[half.triangle];
    surface.creases.push_back({points[half.side], points[(half.side + 1) % 3]});
  }
  return surface;
}

}  // namespace holdfast
