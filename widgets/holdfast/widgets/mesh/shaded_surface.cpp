#include "holdfast/widgets/mesh/shaded_surface.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <span>

#include <holdfast/mesh/edges.h>
#include <holdfast/mesh/vertex_normals.h>
#include <holdfast/numbers/disjoint_sets.h>

namespace holdfast {
namespace {

Vector3 normalOfTriangle(const Model& model, Index triangle)
{
  return unitOrZero(areaVector(model.mesh.positions, model.triangulation.triangles[triangle]));
}

/// Corners are numbered 3 triangle + place.
Index cornerOf(const HalfEdge& half, const std::vector<Triangle>& triangles, Index vertex)
{
  const auto side = static_cast<unsigned char>(half.side);
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
  std::vector<int> pointOf(3 * triangles.size(), -1);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    Triangle points{};
    for (int k = 0; k < 3; ++k) {
      int& point = pointOf[corners.find(3 * static_cast<Index>(t) + k)];
      if (point < 0) {
        point = static_cast<int>(surface.vertexOf.size());
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
  for (const HalfEdge& half : sharp) sets.unite(half.a, half.b);
  std::map<Index, Chain> chains;
  std::set<Index> counted;
  forEachEdge(sharp, [&](std::span<const HalfEdge> halves) {
    const HalfEdge& edge = halves[0];
    Chain& chain = chains[sets.find(edge.a)];
    ++chain.edges;
    chain.length += (mesh.rest.row(edge.a) - mesh.rest.row(edge.b)).stableNorm();
    for (const Index vertex : {edge.a, edge.b}) chain.vertices += counted.insert(vertex).second ? 1 : 0;
  });
  std::vector<HalfEdge> drawn;
  for (const HalfEdge& half : sharp) {
    const Chain& chain = chains[sets.find(half.a)];
    if (chain.edges >= chain.vertices || chain.length >= kLeastCreaseLength * mesh.diagonal) drawn.push_back(half);
  }
  return drawn;
}

}  // namespace

std::vector<Index> ShadedSurface::pointOf(Index vertexCount) const
{
  std::vector<Index> points(static_cast<std::size_t>(vertexCount), -1);
  for (std::size_t k = vertexOf.size(); k-- > 0;) points[vertexOf[k]] = static_cast<Index>(k);
  return points;
}

std::vector<std::array<Index, 2>> ShadedSurface::creasesWithout(const std::vector<char>& isHidden) const
{
  std::vector<char> isSeen(creases.size(), 0);
  for (const auto& [crease, triangle] : creaseSides)
    if (isHidden[triangle] == 0) isSeen[crease] = 1;
  std::vector<std::array<Index, 2>> seen;
  for (std::size_t k = 0; k < creases.size(); ++k)
    if (isSeen[k] != 0) seen.push_back(creases[k]);
  return seen;
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
    if (!isSmooth(halves, model)) {
      sharp.insert(sharp.end(), halves.begin(), halves.end());
      return;
    }
    for (const Index vertex : {halves[0].a, halves[0].b})
      corners.unite(cornerOf(halves[0], triangles, vertex), cornerOf(halves[1], triangles, vertex));
  });
  ShadedSurface surface = numberPoints(model, corners);
  surface.across = std::move(across);
  forEachEdge(drawnEdges(sharp, model.solverMesh), [&](std::span<const HalfEdge> halves) {
    for (const HalfEdge& half : halves)
      surface.creaseSides.push_back({static_cast<Index>(surface.creases.size()), half.triangle});
    const auto points = surface.triangles[halves[0].triangle];
    surface.creases.push_back({points[halves[0].side], points[(halves[0].side + 1) % 3]});
  });
  return surface;
}

}  // namespace holdfast
