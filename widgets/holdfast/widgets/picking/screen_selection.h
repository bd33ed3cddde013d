#pragma once
/// A user selects vertices inside a polygon drawn on the screen: a rectangle or a lasso.

#include <memory>
#include <span>
#include <vector>

#include <holdfast/widgets/camera/display_transform.h>
#include <holdfast/widgets/picking/visible_surface.h>

namespace holdfast {

/// A polygon on the screen, closed from its last corner to its first. A point is inside where a line from it to far
/// away crosses the polygon an odd number of times. Loops of a lasso within one another therefore cut holes.
class ScreenPolygon {
 public:
  /// Makes a polygon of `corners`, which are finite. Fewer than three enclose nothing. O(corners).
  explicit ScreenPolygon(std::span<const DisplayPoint> corners);

  /// Tells whether a point is inside. That takes about O(1) for a lasso of short sides and O(corners) for one that runs
  /// up and down.
  [[nodiscard]] bool contains(const DisplayPoint& point) const;

 private:
  [[nodiscard]] std::size_t bandOf(double y) const;

  [[nodiscard]] const DisplayPoint& endOf(std::size_t side) const { return corners_[(side + 1) % corners_.size()]; }

  std::vector<DisplayPoint> corners_;  // side k leads from corner k to the next
  double bottom_ = 0;
  double top_ = 0;
  std::vector<std::vector<std::size_t>> bands_;  // equally high, from the bottom: the sides that pass through each
};

/// The reach says which vertices inside the polygon a selection takes.
enum class ScreenReach {
  VisibleOnly,  ///< those that the user sees: nothing lies before the vertex
  Through       ///< those behind the surface as well, but not those that a section cuts away or that are not shown
};

/// Finds the vertices of the file that are shown inside `polygon` in the renderer's part of the window, a few at a
/// time. Corners are pixels as a cursor names them. Each means the centre of the pixel.
///
/// Vertices that no face uses are left out. So are vertices behind the eye, vertices that a section cuts away, and
/// vertices whose faces are not shown. O(N) and, for `VisibleOnly`, about O(k log T) for k vertices inside.
///
///     const std::vector<DisplayPoint> corners{{100, 100}, {400, 100}, {250, 300}};
///     ScreenSelection selection(*renderer, surface, corners, ScreenReach::VisibleOnly);
///     while (!selection.isDone()) selection.advance(12000);
///     scene.setSelection(selection.inside());  // SceneContents
class ScreenSelection {
 public:
  /// Selects from what `renderer` shows now of `surface`, which is not null.
  ScreenSelection(vtkRenderer& renderer, std::shared_ptr<const VisibleSurface> surface,
                  std::span<const DisplayPoint> polygon, ScreenReach reach);

  /// Looks at `count` more vertices, or at as many as are left.
  void advance(Index count);
  /// Tells whether all vertices have been looked at.
  [[nodiscard]] bool isDone() const { return next_ == surface_->positions().rows(); }

  /// Returns the vertices inside among those looked at so far, ascending.
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
