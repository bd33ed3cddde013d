#pragma once
/// The edges of the solver's mesh are a graph. It has shortest paths along them, closed curves, and what these enclose.

#include <span>
#include <vector>

#include <holdfast/mesh/index_lists.h>
#include <holdfast/mesh/solver_mesh.h>

namespace holdfast {

/// An edge graph says which unknowns edges join, and how long the edges are.
class EdgeGraph {
 public:
  /// O(T log T).
  explicit EdgeGraph(const SolverMesh& mesh);

  [[nodiscard]] Index vertexCount() const noexcept { return neighbours_.size(); }

  /// Returns the neighbours of a vertex, ascending, each once.
  [[nodiscard]] std::span<const Index> neighbours(Index vertex) const { return neighbours_[vertex]; }

  /// Returns the distance from one vertex to another, as a share of the mesh's diagonal.
  [[nodiscard]] double length(Index a, Index b) const { return ((rest_.row(a) - rest_.row(b)) / diagonal_).norm(); }

 private:
  IndexLists neighbours_;
  Positions rest_;
  double diagonal_;
};

/// Returns the vertices of a shortest path, both ends included, or none where no path joins them. Of paths of the same
/// length it takes the one whose vertices before the end have the smaller ids, seen from the end. Dijkstra's algorithm
/// takes O(k log k) for k vertices that are no farther from `from` than `to` is, and O(N) for memory.
[[nodiscard]] std::vector<Index> shortestPath(const EdgeGraph& graph, Index from, Index to);

/// Returns the vertices of the closed curve through `places`. Shortest paths along edges lead from each place to the
/// next and from the last to the first. There must be one place at least, and all must lie in one connected part. O(N
/// log N) for each place at the most.
[[nodiscard]] std::vector<Index> closedCurve(const EdgeGraph& graph, std::span<const Index> places);

/// A region says how a curve divides the vertices of the connected part that it lies on. Ids ascend.
struct CurveRegion {
  std::vector<Index> curve;
  std::vector<Index> inside;   ///< empty where the curve leaves the part in one piece
  std::vector<Index> outside;  ///< the largest of the pieces; of equally large ones that whose smallest id is largest
};

/// Floods what is left of the part without the vertices of `curve`. All pieces but the largest are inside. O(N).
[[nodiscard]] CurveRegion regionOfCurve(const EdgeGraph& graph, const std::vector<Index>& curve);

}  // namespace holdfast
