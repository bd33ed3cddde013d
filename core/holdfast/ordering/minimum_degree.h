#pragma once
/// Orders that always eliminate the unknown next that has the fewest neighbours left.

#include <span>
#include <vector>

#include <holdfast/base/types.h>
#include <holdfast/ordering/graph.h>

namespace holdfast {

/// Approximate minimum degree (AMD; Amestoy, Davis, Duff, 1996) for the symmetric matrix whose lower triangle is given:
/// the column that is eliminated k-th.
[[nodiscard]] std::vector<int> minimumDegreeOrder(const SparseMatrix& lower);

/// Exact minimum degree for some vertices of a graph, at most a few hundred, that come before all others: the vertex
/// that is eliminated k-th. Each vertex is tied to all that it reaches over two edges. O(k^2 m / 64) for k vertices
/// that are tied to m.
class PieceOrder {
 public:
  explicit PieceOrder(const Graph& graph) : graph_(graph), placeOf_(static_cast<std::size_t>(graph.size()), -1) {}

  [[nodiscard]] std::vector<int> operator()(std::span<const int> piece);

 private:
  const Graph& graph_;
  std::vector<int> placeOf_;  // of vertices in or near the piece
};

}  // namespace holdfast
