#pragma once
/// These orders always eliminate the unknown next that has the fewest neighbours left.

#include <span>
#include <vector>

#include <holdfast/numbers/types.h>
#include <holdfast/ordering/graph.h>

namespace holdfast {

/// Returns an order of approximate minimum degree (AMD; Amestoy, Davis, Duff, 1996) for the symmetric matrix with this
/// lower triangle. The k-th entry is the column that is eliminated k-th.
[[nodiscard]] std::vector<int> minimumDegreeOrder(const SparseMatrix& lower);

/// `PieceOrder` finds orders of exact minimum degree for some vertices of a graph, at most a few hundred, that come
/// before all others. Each vertex is tied to all that it reaches over two edges. A call returns the vertices in the
/// order of elimination. O(k^2 m / 64) for k vertices that are tied to m.
class PieceOrder {
 public:
  explicit PieceOrder(const Graph& graph) : graph_(graph), placeOf_(static_cast<std::size_t>(graph.size()), -1) {}

  [[nodiscard]] std::vector<int> operator()(std::span<const int> piece);

 private:
  const Graph& graph_;
  std::vector<int> placeOf_;  // of vertices in or near the piece
};

}  // namespace holdfast
