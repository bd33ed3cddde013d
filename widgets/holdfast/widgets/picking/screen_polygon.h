#pragma once
/// \file
/// What lies inside a polygon that a user draws on the screen.

#include <span>
#include <vector>

#include <holdfast/widgets/camera/display_transform.h>

namespace holdfast {

/// A polygon on the screen, closed from its last corner to its first. A point is inside where a line from it to far
/// away crosses the polygon an odd number of times, so that loops of a lasso within one another cut holes.
class ScreenPolygon {
 public:
  /// Finite corners; fewer than three enclose nothing. O(corners).
  explicit ScreenPolygon(std::span<const DisplayPoint> corners);

  /// About O(1) for a lasso of short sides, O(corners) for one that runs up and down.
  [[nodiscard]] bool contains(const DisplayPoint& point) const;

 private:
  [[nodiscard]] std::size_t bandOf(double y) const;

  [[nodiscard]] const DisplayPoint& endOf(std::size_t side) const { return corners_[(side + 1) % corners_.size()]; }

  std::vector<DisplayPoint> corners_;  // side k leads from corner k to the next
  double bottom_ = 0;
  double top_ = 0;
  std::vector<std::vector<std::size_t>> bands_;  // equally high, from the bottom: the sides that pass through each
};

}  // namespace holdfast
