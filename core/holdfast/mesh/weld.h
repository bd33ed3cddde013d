#pragma once
/// \file
/// Which vertices of the file are one unknown for the solver: those that coincide exactly along open edges.

#include <vector>

#include <holdfast/mesh/triangulation.h>

namespace holdfast {

/// unknownOf[v] is the unknown of file vertex v; unknowns are numbered by their first vertex.
struct Weld {
  std::vector<Index> unknownOf;
  Index unknownCount = 0;
  std::vector<Index> firstVertexOf;  ///< one file vertex of each unknown, the one of smallest id
};

/// Ties the ends of open edges (edges of one triangle only) that lie exactly on one another, so that an unwelded file
/// such as an STL deforms as the one surface that it shows. Closed parts that merely touch have no open edges and stay
/// apart, as do parts that meet in single points. O(T log T).
[[nodiscard]] Weld weldOpenEdges(const Positions& positions, const std::vector<Triangle>& triangles);

}  // namespace holdfast
