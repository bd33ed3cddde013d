#pragma once
/// A bisection cuts a graph in two parts that few edges join.

#include <array>
#include <cstdint>

#include <holdfast/ordering/coarsening.h>

namespace holdfast {

/// A bisection holds the two parts of a graph, and what they weigh.
struct Bisection {
  std::vector<std::uint8_t> side;  ///< of each vertex: 0 or 1
  std::vector<int> external;       ///< of each vertex: what its edges to the other side weigh
  std::array<std::int64_t, 2> weight{};
  std::int64_t cut = 0;  ///< what the edges between the sides weigh

  /// Brings a vertex to the other side. O(edges of the vertex).
  void move(const Graph& graph, int vertex);
  /// Returns how much less is cut if this vertex moves.
  [[nodiscard]] int gain(const Graph& graph, int vertex) const { return 2 * external[vertex] - graph.degree[vertex]; }
};

/// Cuts a graph in two parts. Neither is heavier than three fifths of the whole, unless single vertices are. The method
/// is multilevel (Karypis and Kumar, 1998). The graph is coarsened until few vertices are left, and a part grows from
/// some of these. On the way back vertices move between the parts while that cuts less (Fiduccia and Mattheyses, 1982).
/// O(edges), nearly. Every run gives the same parts.
[[nodiscard]] Bisection bisect(const Graph& graph);

}  // namespace holdfast
