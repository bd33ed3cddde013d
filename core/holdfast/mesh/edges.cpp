#include "holdfast/mesh/edges.h"

#include <algorithm>
#include <numeric>

#include <holdfast/base/parallel.h>

namespace holdfast {
namespace {

template <class Visitor>
void forEachHalfEdge(const std::vector<Triangle>& triangles, const Visitor& visit)
{
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (int side = 0; side < 3; ++side) {
      const Index from = triangles[t][side];
      const Index to = triangles[t][(side + 1) % 3];
      if (from != to) visit(HalfEdge{std::min(from, to), std::max(from, to), static_cast<Index>(t), side, from < to});
    }
}

}  // namespace

std::vector<HalfEdge> sortedHalfEdges(const std::vector<Triangle>& triangles)
{
  Index vertexCount = 0;
  for (const Triangle& triangle : triangles) vertexCount = std::max(vertexCount, 1 + std::ranges::max(triangle));
  // By the smaller vertex first: place[a + 1] counts up from where those of a begin to where they end.
  std::vector<std::ptrdiff_t> place(static_cast<std::size_t>(vertexCount) + 2, 0);
  forEachHalfEdge(triangles, [&](const HalfEdge& half) { ++place[half.a + 2]; });
  std::partial_sum(place.begin(), place.end(), place.begin());
  std::vector<HalfEdge> halfEdges(static_cast<std::size_t>(place.back()));
  forEachHalfEdge(triangles, [&](const HalfEdge& half) { halfEdges[place[half.a + 1]++] = half; });
  parallelBlocks(vertexCount,
                 [&](Index a) { std::sort(halfEdges.begin() + place[a], halfEdges.begin() + place[a + 1]); });
  return halfEdges;
}

}  // namespace holdfast
