#include "holdfast/mesh/edges.h"

#include <algorithm>
#include <tuple>

namespace holdfast {

std::vector<HalfEdge> sortedHalfEdges(const std::vector<Triangle>& triangles)
{
  std::vector<HalfEdge> halfEdges;
  halfEdges.reserve(3 * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (int side = 0; side < 3; ++side) {
      const Index from = triangles[t][side];
      const Index to = triangles[t][(side + 1) % 3];
      if (from == to) continue;
      halfEdges.push_back({std::min(from, to), std::max(from, to), static_cast<Index>(t), side, from < to});
    }
  std::sort(halfEdges.begin(), halfEdges.end(), [](const HalfEdge& x, const HalfEdge& y) {
    return std::tie(x.a, x.b, x.triangle, x.side) < std::tie(y.a, y.b, y.triangle, y.side);
  });
  return halfEdges;
}

}  // namespace holdfast
