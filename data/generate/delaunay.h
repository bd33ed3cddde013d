#pragma once
/// \file
/// The constrained Delaunay triangulation of a plane region, point by point.

#include <set>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "half_edges.h"

namespace holdfast::generate {

using Vector2 = Eigen::Vector2d;
/// A closed polygon; the last corner is joined to the first.
using Loop = std::vector<Vector2>;

/// Triangulates the region between `loops` (even-odd: holes in any order, any turning sense). The corners of the loops
/// are its first points, in order. Their edges must come out as Delaunay edges, which they do where no two loops are
/// closer than their sampling is wide; throws std::logic_error where one does not.
class Delaunay {
 public:
  explicit Delaunay(const std::vector<Loop>& loops);

  /// Adds a point of the inside; returns its id.
  Index insert(const Vector2& point);
  /// Flips edges until all are Delaunay again, after points have moved.
  void restore();

  [[nodiscard]] const HalfEdges& edges() const { return edges_; }
  [[nodiscard]] const std::vector<Vector2>& points() const { return points_; }
  /// Moves an inner point. Precondition: no triangle turns over.
  void move(Index vertex, const Vector2& place) { points_[vertex] = place; }
  [[nodiscard]] bool isInside(Index face) const { return isInside_[face]; }
  [[nodiscard]] bool isOnBoundary(Index vertex) const { return vertex < boundaryCount_; }
  [[nodiscard]] bool isBoundary(Index halfEdge) const;
  /// The inside face that holds `point`, or `HalfEdges::kNone` where the point is outside the region.
  [[nodiscard]] Index locate(const Vector2& point) const;
  [[nodiscard]] std::vector<Triangle> insideTriangles() const;

 private:
  void surround(const Eigen::AlignedBox2d& box);
  void markBoundary(const std::vector<Loop>& loops);
  void markInside();
  [[nodiscard]] Index findFace(const Vector2& point) const;
  [[nodiscard]] bool shouldFlip(Index halfEdge) const;
  void legalise(std::vector<Index> suspects);

  std::vector<Vector2> points_;  // the last three of the boundary count are the corners of the surrounding triangle
  Index boundaryCount_ = 0;
  HalfEdges edges_;
  std::set<std::pair<Index, Index>> boundary_;
  std::vector<bool> isInside_;
};

/// Twice the signed area.
[[nodiscard]] double orientation(const Vector2& a, const Vector2& b, const Vector2& c);
[[nodiscard]] Vector2 circumcentre(const Vector2& a, const Vector2& b, const Vector2& c);

}  // namespace holdfast::generate
