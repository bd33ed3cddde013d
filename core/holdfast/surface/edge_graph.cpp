#include "holdfast/surface/edge_graph.h"

#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include <holdfast/mesh/edges.h>

namespace holdfast {
namespace {

/// The vertices that edges join to `start` without passing those marked, which they are then; ascending.
std::vector<Index> flooded(const EdgeGraph& graph, Index start, std::vector<bool>& isTaken)
{
  std::vector<Index> piece{start};
  isTaken[start] = true;
  for (std::size_t next = 0; next < piece.size(); ++next)
    for (const Index neighbour : graph.neighbours(piece[next])) {
      if (isTaken[neighbour]) continue;
      isTaken[neighbour] = true;
      piece.push_back(neighbour);
    }
  std::sort(piece.begin(), piece.end());
  return piece;
}

/// Tells whether `a` is the inside rather than `b`: the smaller one, or that with the smallest id where both are as
/// large.
bool isNearerInside(const std::vector<Index>& a, const std::vector<Index>& b)
{
  return a.size() != b.size() ? a.size() < b.size() : a.front() < b.front();
}

}  // namespace

EdgeGraph::EdgeGraph(const SolverMesh& mesh)
    // Edges come sorted by their smaller, then by their larger end: neighbours ascend without being sorted again.
    : neighbours_(mesh.unknownCount(),
                  [halfEdges = sortedHalfEdges(mesh.triangles)](const auto& add) {
                    forEachEdge(halfEdges, [&](std::span<const HalfEdge> edge) {
                      add(edge.front().a, edge.front().b);
                      add(edge.front().b, edge.front().a);
                    });
                  }),
      rest_(mesh.rest),
      diagonal_(mesh.diagonal)
{
}

std::vector<Index> shortestPath(const EdgeGraph& graph, Index from, Index to)
{
  struct Reached {
    double distance = std::numeric_limits<double>::infinity();
    Index previous = -1;  // on the way from the start; that of the start is itself
    bool isSettled = false;
  };
  using Entry = std::pair<double, Index>;
  std::vector<Reached> reached(static_cast<std::size_t>(graph.vertexCount()));
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const auto offer = [&](Index vertex, double distance, Index previous) {
    Reached& known = reached[vertex];
    if (known.isSettled || distance > known.distance) return;
    if (distance == known.distance) {
      known.previous = std::min(known.previous, previous);
      return;
    }
    known = {distance, previous, false};
    queue.emplace(distance, vertex);
  };
  offer(from, 0, from);
  while (!queue.empty() && !reached[to].isSettled) {
    const Index vertex = queue.top().second;
    queue.pop();
    if (std::exchange(reached[vertex].isSettled, true)) continue;
    for (const Index neighbour : graph.neighbours(vertex))
      offer(neighbour, reached[vertex].distance + graph.length(vertex, neighbour), vertex);
  }
  if (reached[to].previous < 0) return {};
  std::vector<Index> vertices{to};
  while (vertices.back() != from) vertices.push_back(reached[vertices.back()].previous);
  std::reverse(vertices.begin(), vertices.end());
  return vertices;
}

std::vector<Index> closedCurve(const EdgeGraph& graph, std::span<const Index> places)
{
  std::vector<Index> curve;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const std::vector<Index> path = shortestPath(graph, places[k], places[(k + 1) % places.size()]);
    assert(!path.empty());
    // The end is the start of the next path.
    curve.insert(curve.end(), path.begin(), path.end() - 1);
  }
  return curve;
}

CurveRegion regionOfCurve(const EdgeGraph& graph, const std::vector<Index>& curve)
{
  CurveRegion region{sortedOnce(curve), {}, {}};
  std::vector<bool> isTaken(static_cast<std::size_t>(graph.vertexCount()), false);
  for (const Index v : region.curve) isTaken[v] = true;
  for (const Index v : region.curve)
    for (const Index neighbour : graph.neighbours(v)) {
      if (isTaken[neighbour]) continue;
      std::vector<Index> piece = flooded(graph, neighbour, isTaken);
      if (isNearerInside(region.outside, piece)) std::swap(region.outside, piece);
      region.inside.insert(region.inside.end(), piece.begin(), piece.end());
    }
  std::sort(region.inside.begin(), region.inside.end());
  return region;
}

}  // namespace holdfast
