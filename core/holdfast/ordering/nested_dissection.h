#pragma once
/// Nested dissection (George, 1973) of the vertices of a mesh.

#include <vector>

#include <holdfast/ordering/graph.h>

namespace holdfast {

/// Of each vertex its place in an order of elimination for a matrix that ties it to all that it reaches over two edges
/// of `graph`, whose weights are 1. O(edges log n), over threads; the same for any number of them.
///
/// The graph is cut in two parts. All vertices with an edge across the cut come last: two layers, so that no path of
/// two edges leads past them. What is left of each part is cut again, with those that came last around it, since paths
/// lead over them; and so on down to small pieces.
[[nodiscard]] std::vector<int> nestedDissection(Graph graph);

}  // namespace holdfast
