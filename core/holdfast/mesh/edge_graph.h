#pragma once
/// The edges of the solver's mesh as a graph, and the shortest ways along them.

#include <span>
#include <vector>

#include <holdfast/mesh/solver_mesh.h>

namespace holdfast {

/// Which unknowns edges join, and how long the edges are.
class EdgeGraph {
 public:
  /// O(T log T).
  explicit EdgeGraph(const SolverMesh& mesh);

  [[nodiscard]] Index vertexCount() const noexcept { return static_cast<Index>(starts_.size()) - 1; }

  /// Ascending, each once.
  [[nodiscard]] std::span<const Index> neighbours(Index vertex) const { return of(neighbours_, vertex); }
  /// Lengths of the edges to those neighbours, in the same order, as shares of the mesh's diagonal.
  [[nodiscard]] std::span<const double> lengths(Index vertex) const { return of(lengths_, vertex); }

 private:
  template <class Value>
  [[nodiscard]] std::span<const Value> of(const std::vector<Value>& values, Index vertex) const
  {
    return std::span(values).subspan(static_cast<std::size_t>(starts_[vertex]),
                                     static_cast<std::size_t>(starts_[vertex + 1] - starts_[vertex]));
  }

  std::vector<Index> starts_;  // of each vertex in what follows, and the end
  std::vector<Index> neighbours_;
  std::vector<double> lengths_;
};

/// Finds shortest paths in one graph, by Dijkstra's algorithm. Keeps its memory between paths.
class ShortestPaths {
 public:
  /// `graph` stays alive as long as this.
  explicit ShortestPaths(const EdgeGraph& graph)
      : graph_(graph), reached_(static_cast<std::size_t>(graph.vertexCount()))
  {
  }

  /// The vertices of a shortest path, both ends included; none where no path joins them. Of paths of the same length
  /// the one whose vertices before the end have the smaller ids, seen from the end. O(k log k) for k vertices that are
  /// no farther from `from` than `to` is.
  [[nodiscard]] std::vector<Index> path(Index from, Index to);

 private:
  struct Reached {
    double distance = 0;
    Index previous = -1;  // on the way from the start; that of the start is itself, -1 where no way is known
    bool isSettled = false;
  };

  void search(Index from, Index to);
  [[nodiscard]] bool offer(Index vertex, double distance, Index previous);

  const EdgeGraph& graph_;
  std::vector<Reached> reached_;
  std::vector<Index> touched_;  // what has to be set back
};

}  // namespace holdfast
