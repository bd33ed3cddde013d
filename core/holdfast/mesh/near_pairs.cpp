#include "holdfast/mesh/near_pairs.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace holdfast {
namespace {

using Cell = std::array<std::int64_t, 3>;

struct CellEntry {
  Cell cell;
  int vertex = 0;

  friend auto operator<=>(const CellEntry&, const CellEntry&) = default;
};

// Cells along an axis at most: their numbers are exact as doubles, and so are those of their neighbours.
constexpr double kMostCells = 0x1p52;

/// The vertices in cubes of side `size`, sorted.
std::vector<CellEntry> sortedByCell(const Positions& positions, std::span<const int> vertices, double size)
{
  const Eigen::RowVector3d low = positions(vertices, Eigen::all).colwise().minCoeff();
  std::vector<CellEntry> entries;
  entries.reserve(vertices.size());
  for (const int v : vertices) {
    CellEntry& entry = entries.emplace_back(CellEntry{{}, v});
    for (int k = 0; k < 3; ++k)
      entry.cell[k] = static_cast<std::int64_t>(std::floor(std::min((positions(v, k) - low[k]) / size, kMostCells)));
  }
  std::ranges::sort(entries);
  return entries;
}

/// A cell and half of its neighbours: together with those of the others every pair of neighbours is met once.
std::vector<Cell> halfOfNeighbours()
{
  std::vector<Cell> steps;
  for (std::int64_t x = -1; x <= 1; ++x)
    for (std::int64_t y = -1; y <= 1; ++y)
      for (std::int64_t z = -1; z <= 1; ++z)
        if (const Cell step{x, y, z}; step >= Cell{0, 0, 0}) steps.push_back(step);
  return steps;
}

}  // namespace

std::vector<std::array<int, 2>> nearPairs(const Positions& positions, std::span<const int> vertices, double distance)
{
  std::vector<std::array<int, 2>> pairs;
  if (vertices.empty()) return pairs;
  const std::vector<CellEntry> entries = sortedByCell(positions, vertices, distance);
  const std::vector<Cell> steps = halfOfNeighbours();
  for (const CellEntry& entry : entries)
    for (const Cell& step : steps) {
      const Cell cell{entry.cell[0] + step[0], entry.cell[1] + step[1], entry.cell[2] + step[2]};
      for (auto other = std::ranges::lower_bound(entries, cell, {}, &CellEntry::cell);
           other != entries.end() && other->cell == cell; ++other)
        if ((cell != entry.cell || entry.vertex < other->vertex) &&
            (positions.row(entry.vertex) - positions.row(other->vertex)).stableNorm() <= distance)
          pairs.push_back({std::min(entry.vertex, other->vertex), std::max(entry.vertex, other->vertex)});
    }
  std::ranges::sort(pairs);
  return pairs;
}

}  // namespace holdfast
