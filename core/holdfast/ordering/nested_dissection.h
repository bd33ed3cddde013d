#pragma once
/// Nested dissection (George, 1973) orders the vertices of a mesh.

#include <vector>

#include <holdfast/ordering/graph.h>

namespace holdfast {

/// Returns the place of each vertex in an order of elimination. The order is for a matrix that ties each vertex to all
/// that it reaches over two edges of `graph`. The weights of `graph` are 1. O(edges log n), over threads. The result is
/// the same for any number of them.
///
/// The graph is cut in two parts. All vertices with an edge across the cut come last. These are two layers, so no path
/// of two edges leads past them. What is left of each part is cut again, with those that came last around it, since
/// paths lead over them. This goes on down to small pieces.
[[nodiscard]] std::vector<int> nestedDissection(const Graph& graph);

}  // namespace holdfast
