#pragma once
/// Coarsening makes a graph with half as many vertices that is shaped like a given one.

#include <random>

#include <holdfast/ordering/graph.h>

namespace holdfast {

/// This engine gives the same numbers everywhere. It is used alone, with no distribution of the standard library.
using RandomNumbers = std::minstd_rand;

struct CoarserGraph {
  Graph graph;
  std::vector<int> clusterOf;  ///< of each vertex of the finer graph: its vertex in `graph`
};

/// Visits vertices in a random order and joins each with the free neighbour that its heaviest edge leads to (Karypis
/// and Kumar, 1998). It joins none that weigh more than `mostWeight` together. Edges that then join the same ends
/// become one, which weighs as much as they did together. O(edges).
[[nodiscard]] CoarserGraph coarsened(const Graph& graph, int mostWeight, RandomNumbers& random);

}  // namespace holdfast
