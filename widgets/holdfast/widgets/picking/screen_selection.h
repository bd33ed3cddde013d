#pragma once
/// The vertices inside a polygon drawn on the screen: a rectangle or a lasso.

#include <memory>
#include <span>
#include <vector>

#include <holdfast/widgets/camera/display_transform.h>
#include <holdfast/widgets/picking/visible_surface.h>

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

enum class ScreenReach {
  VisibleOnly,  ///< what the user sees: nothing lies before the vertex
  Through       ///< what is behind the surface as well, but not what a section cuts away or is not shown
};

/// The vertices of the file that are shown inside `polygon` in the renderer's part of the window, found a few at a
/// time. Corners are pixels as a cursor names them, each meaning its center. Without vertices that no face uses, that
/// are behind the eye, that a section cuts away or whose faces are not shown. O(N) and, for `VisibleOnly`, about O(k
/// log T) for k vertices inside.
class ScreenSelection {
 public:
  /// Sees what `renderer` shows now of `surface`, which is not null.
  ScreenSelection(vtkRenderer& renderer, std::shared_ptr<const VisibleSurface> surface,
                  std::span<const DisplayPoint> polygon, ScreenReach reach);

  /// Looks at `count` vertices more, or as many as are left.
  void advance(Index count);
  [[nodiscard]] bool isDone() const { return next_ == surface_->positions().rows(); }

  /// The vertices looked at so far that are inside, ascending.
  [[nodiscard]] const std::vector<Index>& inside() const noexcept { return inside_; }

 private:
  [[nodiscard]] bool isInside(Index vertex) const;

  std::shared_ptr<const VisibleSurface> surface_;
  DisplayTransform display_;
  ScreenPolygon outline_;
  ScreenReach reach_;
  Index next_ = 0;
  std::vector<Index> inside_;
};

}  // namespace holdfast
