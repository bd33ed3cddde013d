#pragma once
/// Where rays meet a surface, and meet it again where it has moved to.

#include <array>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <holdfast/surface/triangle_tree.h>

namespace holdfast {

/// The places origin + t direction with t > 0. The direction is not zero and need not be of unit length.
struct Ray {
  Vector3 origin = Vector3::Zero();
  Vector3 direction = Vector3::UnitZ();
};

/// The places of a ray from `begin` to `end`; none where `begin` > `end`.
struct RayRange {
  double begin = 0;  ///< in lengths of the ray's direction
  double end = std::numeric_limits<double>::infinity();
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

/// Intersects rays with triangles, seen from either side, through a tree of boxes. Never changes; copies cost nothing.
/// Rays do not slip through between triangles that share an edge. Triangles without an area are not hit. Products of
/// two lengths should lie between 1e-140 and 1e140.
class RayCaster {
 public:
  /// Finite positions. O(T log T).
  RayCaster(const Positions& positions, std::vector<Triangle> triangles);

  /// For the same triangles at other finite positions. O(1); shares all but the boxes.
  [[nodiscard]] RayCaster movedTo(std::shared_ptr<const Positions> positions) const
  {
    return RayCaster(tree_, std::move(positions)).without(isLeftOut_);
  }

  /// The same without the triangles for which `isLeftOut`, one for each; null: with all of them. O(1).
  [[nodiscard]] RayCaster without(std::shared_ptr<const std::vector<char>> isLeftOut) const
  {
    RayCaster some(*this);
    some.isLeftOut_ = std::move(isLeftOut);
    return some;
  }
  [[nodiscard]] bool isLeftOut(Index triangle) const { return isLeftOut_ && (*isLeftOut_)[triangle] != 0; }

  [[nodiscard]] const Positions& positions() const noexcept { return *positions_; }

  /// Makes the boxes, which the first ray makes otherwise. On any thread; for all copies. O(T).
  void prepare() const { static_cast<void>(boxes_->get(*tree_, *positions_)); }

  /// The first that the ray meets within `range`; of several at one place that of smallest id. About O(log T).
  [[nodiscard]] std::optional<RayHit> firstHit(const Ray& ray, const RayRange& range = {}) const;

  /// Whether the ray meets a triangle at `from` <= t < `before`, but for `ignored`, which ascend. About O(log T).
  [[nodiscard]] bool isBlocked(const Ray& ray, double before, std::span<const Index> ignored, double from = 0) const;

  /// Where a plane through `origin`, across `normal` (not zero), cuts the triangles: a segment of each that has corners
  /// on both sides. About O(segments log T).
  [[nodiscard]] std::vector<std::array<Vector3, 2>> cutBy(const Vector3& origin, const Vector3& normal) const;

  /// All triangles that have a point within reach of the ray, and some that almost have; ascending.
  [[nodiscard]] std::vector<Index> withinReach(const Ray& ray, const RayReach& reach) const;

 private:
  class Caster;

  /// The boxes of a tree: made when they are first asked for, once, whatever threads ask.
  class Boxes {
   public:
    const TriangleTree::Boxes& get(const TriangleTree& tree, const Positions& positions)
    {
      std::call_once(areMade_, [&] { boxes_ = tree.boxesAt(positions); });
      return boxes_;
    }

   private:
    std::once_flag areMade_;
    TriangleTree::Boxes boxes_;
  };

  RayCaster(std::shared_ptr<const TriangleTree> tree, std::shared_ptr<const Positions> positions);

  /// As `TriangleTree::visit`, without what is left out.
  template <class Entry, class Visit>
  void visit(Entry&& entry, const double& limit, Visit&& visit) const
  {
    tree_->visit(boxes_->get(*tree_, *positions_), entry, limit,
                 [&](Index triangle) { return !isLeftOut(triangle) && visit(triangle); });
  }

  std::shared_ptr<const TriangleTree> tree_;
  std::shared_ptr<const Positions> positions_;
  std::shared_ptr<Boxes> boxes_ = std::make_shared<Boxes>();  // at the positions
  std::shared_ptr<const std::vector<char>> isLeftOut_;
};

}  // namespace holdfast
