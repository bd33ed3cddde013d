#pragma once
/// The point of a surface that is closest to a place in space.

#include <holdfast/surface/surface_point.h>
#include <holdfast/surface/triangle_tree.h>

namespace holdfast {

/// Weights of a triangle's corners; none negative, of sum 1, exact zeros on edges and vertices.
struct TrianglePoint {
  std::array<double, 3> weights{};
  Vector3 position = Vector3::Zero();
  double squaredDistance = 0;
};

/// The point of one triangle closest to `place`. Triangles that are segments or points are fine. Fourth powers of
/// lengths are taken: they should lie between 1e-70 and 1e70.
[[nodiscard]] TrianglePoint closestPointOfTriangle(const std::array<Vector3, 3>& corners, const Vector3& place);

/// Finds closest points through a tree of boxes, at any size of the surface. Holds copies of what it needs.
class ClosestPointSearch {
 public:
  /// Finite positions, at least one triangle. O(T log T).
  ClosestPointSearch(const Positions& positions, const std::vector<Triangle>& triangles);

  struct Result {
    SurfacePoint point;
    Index triangle = 0;
    double distance = 0;  ///< model units
  };

  /// The exact closest point of a finite place; of triangles at the same distance the one that comes first.
  [[nodiscard]] Result find(const Vector3& place) const;

 private:
  int exponent_;         // the unit of what follows is 2^exponent model units
  Positions positions_;  // in that unit: squares stay within the range of doubles
  TriangleTree tree_;
  TriangleTree::Boxes boxes_;
};

}  // namespace holdfast
