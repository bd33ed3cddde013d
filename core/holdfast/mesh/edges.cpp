#include "holdfast/mesh/edges.h"

#include <numeric>

#include <holdfast/threads/parallel.h>

namespace holdfast {
namespace {

/// Visits half-edges of edges whose smaller vertex is one of `first` .. `last` - 1.
template <class Visitor>
void forEachHalfEdge(const std::vector<Triangle>& triangles, Index first, Index last, const Visitor& visit)
{
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::int8_t side = 0; side < 3; ++side) {
      const int from = triangles[t][side];
      const int to = triangles[t][(side + 1) % 3];
      const int a = std::min(from, to);
      if (from != to && first <= a && a < last)
        visit(HalfEdge{a, std::max(from, to), static_cast<int>(t), side, from < to});
    }
}

}  // namespace

std::vector<HalfEdge> sortedHalfEdges(const std::vector<Triangle>& triangles)
{
  int vertexCount = 0;
  for (const Triangle& triangle : triangles) vertexCount = std::max(vertexCount, 1 + std::ranges::max(triangle));
  const Index parts = threadCount();
  const auto forEachOfPart = [&](Index part, const auto& visit) {
    forEachHalfEdge(triangles, part * vertexCount / parts, (part + 1) * vertexCount / parts, visit);
  };
  // By the smaller vertex first: place[a + 1] counts up from where those of a begin to where they end.
  std::vector<int> place(static_cast<std::size_t>(vertexCount) + 2, 0);
  parallelFor(parts, [&](Index part) { forEachOfPart(part, [&](const HalfEdge& half) { ++place[half.a + 2]; }); });
  std::partial_sum(place.begin(), place.end(), place.begin());
  std::vector<HalfEdge> halfEdges(static_cast<std::size_t>(place.back()));
  parallelFor(parts, [&](Index part) {
    forEachOfPart(part, [&](const HalfEdge& half) { halfEdges[place[half.a + 1]++] = half; });
  });
  parallelBlocks(vertexCount,
                 [&](Index a) { std::sort(halfEdges.begin() + place[a], halfEdges.begin() + place[a + 1]); });
  return halfEdges;
}

}  // namespace holdfast
