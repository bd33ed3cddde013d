#include "holdfast/widgets/marks/evenly_spread.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <unordered_map>

#include <Eigen/Geometry>

namespace holdfast {
namespace {

constexpr int kMostTries = 6;

// A share of the target.
constexpr double kFew = 0.85;
constexpr double kMany = 1.15;

// Cells along one side of the box around all points: their numbers fit into a third of a key.
constexpr double kMostCells = 1e6;

/// Points by the cells of a grid, to find those near a place.
class Grid {
 public:
  Grid(const Positions& points, const Vector3& origin, double cellSize)
      : points_(points), origin_(origin), cellSize_(cellSize)
  {
  }

  /// Tells whether one of those added is nearer than the size of a cell.
  [[nodiscard]] bool hasNear(Index point) const
  {
    const Cell own = cellOf(point);
    for (std::int64_t dx = -1; dx <= 1; ++dx)
      for (std::int64_t dy = -1; dy <= 1; ++dy)
        for (std::int64_t dz = -1; dz <= 1; ++dz)
          if (hasNearIn(own + Cell(dx, dy, dz), point)) return true;
    return false;
  }

  void add(Index point) { inCell_[keyOf(cellOf(point))].push_back(point); }

 private:
  using Cell = Eigen::Array<std::int64_t, 3, 1>;

  [[nodiscard]] Cell cellOf(Index point) const
  {
    return ((points_.row(point).transpose() - origin_) / cellSize_).array().cast<std::int64_t>();
  }

  [[nodiscard]] static std::int64_t keyOf(const Cell& cell)
  {
    constexpr int kBits = 21;
    return ((cell.x() + 1) << (2 * kBits)) + ((cell.y() + 1) << kBits) + cell.z() + 1;
  }

  [[nodiscard]] bool hasNearIn(const Cell& cell, Index point) const
  {
    const auto found = inCell_.find(keyOf(cell));
    if (found == inCell_.end()) return false;
    return std::any_of(found->second.begin(), found->second.end(), [&](Index other) {
      return ((points_.row(other) - points_.row(point)) / cellSize_).squaredNorm() < 1;
    });
  }

  const Positions& points_;
  Vector3 origin_;
  double cellSize_;
  std::unordered_map<std::int64_t, std::vector<Index>> inCell_;  // never walked through: its order does not matter
};

/// Takes each point that is `distance` or more from all that were taken before it.
std::vector<Index> spread(const Positions& points, const std::vector<Index>& among, const Vector3& origin,
                          double distance)
{
  Grid taken(points, origin, distance);
  std::vector<Index> places;
  for (const Index k : among) {
    if (taken.hasNear(k)) continue;
    taken.add(k);
    places.push_back(k);
  }
  return places;
}

}  // namespace

std::vector<Index> evenlySpread(const Positions& points, const std::vector<Index>& among, Index target)
{
  if (static_cast<Index>(among.size()) <= target) return among;
  Eigen::AlignedBox3d box;
  for (const Index k : among) box.extend(points.row(k).transpose());
  const double diagonal = box.sizes().stableNorm();
  if (diagonal == 0) return {among.front()};
  const auto wanted = static_cast<double>(target);
  double distance = diagonal / std::sqrt(wanted);
  std::vector<Index> places;
  for (int attempt = 0; attempt < kMostTries; ++attempt) {
    places = spread(points, among, box.min(), distance);
    const double share = static_cast<double>(places.size()) / wanted;
    if (share >= kFew && share <= kMany) break;
    // On a surface there are as many as discs of this size fit on it.
    distance = std::clamp(distance * std::sqrt(share), diagonal / kMostCells, diagonal);
  }
  return places;
}

std::vector<Index> evenlySpread(const Positions& points, Index target)
{
  std::vector<Index> all(static_cast<std::size_t>(points.rows()));
  std::iota(all.begin(), all.end(), Index{0});
  return evenlySpread(points, all, target);
}

}  // namespace holdfast
