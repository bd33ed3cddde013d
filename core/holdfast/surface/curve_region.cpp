#include "holdfast/surface/curve_region.h"

#include <algorithm>
#include <cassert>
#include <utility>

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

/// Whether `a` is the inside rather than `b`: the smaller one, or that with the smallest id where both are as large.
bool isNearerInside(const std::vector<Index>& a, const std::vector<Index>& b)
{
  return a.size() != b.size() ? a.size() < b.size() : a.front() < b.front();
}

}  // namespace

std::vector<Index> closedCurve(const EdgeGraph& graph, std::span<const Index> places)
{
  ShortestPaths paths(graph);
  std::vector<Index> curve;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const std::vector<Index> path = paths.path(places[k], places[(k + 1) % places.size()]);
    assert(!path.empty());
    // The end is the start of the next path.
    curve.insert(curve.end(), path.begin(), path.end() - 1);
  }
  return curve;
}

CurveRegion regionOfCurve(const EdgeGraph& graph, const std::vector<Index>& curve)
{
  CurveRegion region{curve, {}, {}};
  std::sort(region.curve.begin(), region.curve.end());
  region.curve.erase(std::unique(region.curve.begin(), region.curve.end()), region.curve.end());
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
