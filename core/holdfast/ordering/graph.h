#pragma once
/// These graphs are cut in pieces.

#include <vector>

namespace holdfast {

/// A graph has vertices and edges with weights. Each edge is in the lists of both of its ends.
struct Graph {
  std::vector<int> start{0};  ///< of the edges of each vertex, and the end
  std::vector<int> neighbour;
  std::vector<int> edgeWeight;
  std::vector<int> weight;  ///< of each vertex
  std::vector<int> degree;  ///< of each vertex: what its edges weigh together

  [[nodiscard]] int size() const noexcept { return static_cast<int>(start.size()) - 1; }

  /// Calls `visit(neighbour, edgeWeight)` for each edge of a vertex.
  template <class Visit>
  void forEachEdge(int vertex, const Visit& visit) const
  {
    for (int e = start[vertex]; e < start[vertex + 1]; ++e) visit(neighbour[e], edgeWeight[e]);
  }
};

}  // namespace holdfast
