#pragma once
/// A graph in two parts that few edges join.

#include <array>
#include <cstdint>

#include <holdfast/ordering/coarsening.h>

namespace holdfast {

/// A graph in two parts, and what they weigh.
struct Bisection {
  std::vector<std::uint8_t> side;  ///< of each vertex: 0 or 1
  std::vector<int> external;       ///< of each vertex: what its edges to the other side weigh
  std::array<std::int64_t, 2> weight{};
  std::int64_t cut = 0;  ///< what the edges between the sides weigh

  /// Brings a vertex to the other side. O(edges of the vertex).
  void move(const Graph& graph, int vertex);
  /// How much less is cut if this vertex moves.
  [[nodiscard]] int gain(const Graph& graph, int vertex) const { return 2 * external[vertex] - graph.degree[vertex]; }
};

/// Two parts, neither heavier than three fifths of the whole, unless single vertices are. Multilevel (Karypis and
/// Kumar, 1998): the graph is coarsened until few vertices are left; from some of these a part grows; on the way back
/// vertices move between the parts while that cuts less (Fiduccia and Mattheyses, 1982). O(edges), nearly. The same on
/// every run.
[[nodiscard]] Bisection bisect(const Graph& graph);

}  // namespace holdfast
