#include "holdfast/mesh/edge_graph.h"

#include <algorithm>
#include <functional>
#include <queue>
#include <utility>

#include <holdfast/mesh/edges.h>

namespace holdfast {
namespace {

/// Where the neighbours of each vertex start, and where the last end.
std::vector<Index> startsOf(const std::vector<HalfEdge>& halfEdges, Index vertexCount)
{
  std::vector<Index> starts(static_cast<std::size_t>(vertexCount) + 1, 0);
  forEachEdge(halfEdges, [&](std::span<const HalfEdge> edge) {
    ++starts[edge.front().a + 1];
    ++starts[edge.front().b + 1];
  });
  for (Index v = 0; v < vertexCount; ++v) starts[v + 1] += starts[v];
  return starts;
}

}  // namespace

EdgeGraph::EdgeGraph(const SolverMesh& mesh)
{
  const std::vector<HalfEdge> halfEdges = sortedHalfEdges(mesh.triangles);
  starts_ = startsOf(halfEdges, mesh.unknownCount());
  neighbours_.resize(static_cast<std::size_t>(starts_.back()));
  lengths_.resize(neighbours_.size());
  std::vector<Index> next(starts_.begin(), starts_.end() - 1);
  const auto add = [&](Index vertex, Index neighbour, double length) {
    neighbours_[next[vertex]] = neighbour;
    lengths_[next[vertex]++] = length;
  };
  // Edges come sorted by their smaller, then by their larger end: neighbours ascend without being sorted again.
  forEachEdge(halfEdges, [&](std::span<const HalfEdge> edge) {
    const auto [a, b] = std::pair(edge.front().a, edge.front().b);
    const double length = ((mesh.rest.row(a) - mesh.rest.row(b)) / mesh.diagonal).norm();
    add(a, b, length);
    add(b, a, length);
  });
}

std::vector<Index> ShortestPaths::path(Index from, Index to)
{
  search(from, to);
  std::vector<Index> vertices;
  if (reached_[to].previous >= 0) {
    for (Index v = to; v != from; v = reached_[v].previous) vertices.push_back(v);
    vertices.push_back(from);
    std::reverse(vertices.begin(), vertices.end());
  }
  for (const Index v : touched_) reached_[v] = {};
  touched_.clear();
  return vertices;
}

void ShortestPaths::search(Index from, Index to)
{
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  if (offer(from, 0, from)) queue.emplace(0, from);
  while (!queue.empty() && !reached_[to].isSettled) {
    const Index vertex = queue.top().second;
    queue.pop();
    if (std::exchange(reached_[vertex].isSettled, true)) continue;
    const std::span<const Index> neighbours = graph_.neighbours(vertex);
    for (std::size_t k = 0; k < neighbours.size(); ++k) {
      const double distance = reached_[vertex].distance + graph_.lengths(vertex)[k];
      if (offer(neighbours[k], distance, vertex)) queue.emplace(distance, neighbours[k]);
    }
  }
}

/// Takes a way to `vertex` over if it is better than the one known; whether the distance has changed.
bool ShortestPaths::offer(Index vertex, double distance, Index previous)
{
  Reached& known = reached_[vertex];
  if (known.isSettled) return false;
  if (known.previous < 0) {
    touched_.push_back(vertex);
    known = {distance, previous, false};
    return true;
  }
  if (distance == known.distance) known.previous = std::min(known.previous, previous);
  if (distance >= known.distance) return false;
  known = {distance, previous, false};
  return true;
}

}  // namespace holdfast
