#pragma once
/// \file
/// Where rays meet a surface that moves.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include <holdfast/mesh/triangulation.h>

namespace holdfast {

/// The places origin + t direction with t > 0. The direction is not zero and need not be of unit length.
struct Ray {
  Vector3 origin = Vector3::Zero();
  Vector3 direction = Vector3::UnitZ();
};

/// The places that are no farther than `radius` + `slope` t from the place at t of a ray: a cylinder or a cone.
struct RayReach {
  double radius = 0;  ///< model units
  double slope = 0;   ///< model units for each length of the ray's direction
};

/// A point where a ray meets a triangle.
struct RayHit {
  Index triangle = 0;
  double t = 0;                     ///< in lengths of the ray's direction
  std::array<double, 3> weights{};  ///< of the triangle's corners; none negative, of sum 1 to rounding
};

/// Intersects rays with triangles, seen from either side, through a tree of boxes. The tree divides the triangles as
/// they lie when it is made and its boxes follow them, so that moving the surface costs a fraction of making a tree.
/// Rays do not slip through between triangles that share an edge. Triangles without an area are not hit. Products of
/// two lengths are taken: they should lie between 1e-140 and 1e140.
class RayCaster {
 public:
  /// Finite positions. O(T log T).
  RayCaster(const Positions& positions, std::vector<Triangle> triangles);

  /// Moves the surface. O(T).
  void setPositions(const Positions& positions);
  [[nodiscard]] const Positions& positions() const noexcept { return positions_; }

  /// The first of the triangles that the ray meets; of several at the same place that of smallest id. About O(log T).
  [[nodiscard]] std::optional<RayHit> firstHit(const Ray& ray) const;

  /// Whether the ray meets a triangle at t < `before` other than those `ignored`, whose ids ascend. About O(log T).
  [[nodiscard]] bool isBlocked(const Ray& ray, double before, std::span<const Index> ignored) const;

  /// All triangles that have a point within reach of the ray, and some that almost have; ascending. About O(log T) and
  /// what it finds.
  [[nodiscard]] std::vector<Index> withinReach(const Ray& ray, const RayReach& reach) const;

 private:
  struct Node {
    Eigen::AlignedBox3d box;
    Index first = 0;   // of its triangles in `order_`
    Index last = 0;    // past the last of them
    Index second = 0;  // node of its second half; that of the first half is the next one; 0 for a leaf
  };
  class Caster;

  Index addNode(Index first, Index last, const Positions& centers);
  [[nodiscard]] Eigen::AlignedBox3d boxOf(Index triangle) const;
  [[nodiscard]] Eigen::AlignedBox3d boxOf(const Node& leaf) const;
  void fitBoxes();
  template <class Entry, class Visitor>
  void visitLeaves(const Entry& entryOf, const double& limit, Visitor&& visit) const;

  std::vector<Triangle> triangles_;
  std::vector<Index> order_;  // triangles as the leaves hold them
  std::vector<Node> nodes_;   // each before those below it
  Positions positions_;
};

}  // namespace holdfast
