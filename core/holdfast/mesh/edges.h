#pragma once
/// Half edges list the edges of a set of triangles, each once, with the triangles on it.

#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include <holdfast/mesh/triangulation.h>

namespace holdfast {

/// A half edge is one side of one triangle. Its numbers have 32 bits: lists of them are as fast as they are small.
struct HalfEdge {
  int a = 0;  ///< the smaller vertex id of the edge
  int b = 0;  ///< the larger
  int triangle = 0;
  std::int8_t side = 0;    ///< the edge runs between corners side and side + 1 of the triangle
  bool isForward = false;  ///< the triangle runs through it from a to b

  friend auto operator<=>(const HalfEdge&, const HalfEdge&) = default;
};

/// Returns all half edges sorted by (a, b, triangle), so that those of one edge are side by side. Sides that join a
/// vertex to itself are left out. O(T) where no vertex has many.
[[nodiscard]] std::vector<HalfEdge> sortedHalfEdges(const std::vector<Triangle>& triangles);

/// Calls `visit(std::span<const HalfEdge>)` once for each edge with its half edges.
template <class Visitor>
void forEachEdge(const std::vector<HalfEdge>& halfEdges, Visitor&& visit)
{
  for (std::size_t first = 0; first < halfEdges.size();) {
    std::size_t last = first + 1;
    while (last < halfEdges.size() && halfEdges[last].a == halfEdges[first].a &&
           halfEdges[last].b == halfEdges[first].b)
      ++last;
    visit(std::span<const HalfEdge>(halfEdges.data() + first, last - first));
    first = last;
  }
}

}  // namespace holdfast
