#pragma once
/// A place tree finds the nearest of many places.

#include <limits>

#include <holdfast/surface/triangle_tree.h>

namespace holdfast {

/// Finds places among some that stay alive as long as this and are finite.
class PlaceTree {
 public:
  /// O(n log n).
  explicit PlaceTree(const Positions& places);

  /// Returns which place is nearest to `from`, within `reach`, and is not `except`. It is the first of those that are
  /// as near. Returns -1 where there is none. O(log n) for places that are spread evenly.
  [[nodiscard]] Index nearest(const Vector3& from, double reach = std::numeric_limits<double>::max(),
                              Index except = -1) const;

 private:
  const Positions& places_;
  TriangleTree tree_;  // of triangles that are points
  TriangleTree::Boxes boxes_;
};

}  // namespace holdfast
