#pragma once
/// A ray caster finds where rays meet a surface, and where they meet it again when it has moved.

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

/// A ray is the places origin + t direction with t > 0. The direction is not zero and need not be of unit length.
struct Ray {
  Vector3 origin = Vector3::Zero();
  Vector3 direction = Vector3::UnitZ();
};

/// A range is the places of a ray from `begin` to `end`. It has none where `begin` > `end`.
struct RayRange {
  double begin = 0;  ///< in lengths of the ray's direction
  double end = std::numeric_limits<double>::infinity();
};

/// A reach is the places that are no farther than `radius` + `slope` t from the place at t of a ray. It is a cylinder
/// or a cone.
struct RayReach {
  double radius = 0;  ///< model units
  double slope = 0;   ///< model units for each length of the ray's direction
};

/// A hit is a point where a ray meets a triangle.
struct RayHit {
  Index triangle = 0;
  double t = 0;                     ///< in lengths of the ray's direction
  std::array<double, 3> weights{};  ///< of the triangle's corners; none negative, of sum 1 to rounding
};

/// A ray caster intersects rays with triangles, seen from either side, through a tree of boxes. It never changes, and
/// copies cost nothing. Rays do not slip through between triangles that share an edge. Triangles without an area are
/// not hit. Products of two lengths should lie between 1e-140 and 1e140.
class RayCaster {
 public:
  /// Positions must be finite. O(T log T).
  RayCaster(const Positions& positions, std::vector<Triangle> triangles);

  /// Returns a caster for the same triangles at other finite positions. It shares all but the boxes. O(1).
  [[nodiscard]] RayCaster movedTo(std::shared_ptr<const Positions> positions) const
  {
    return RayCaster(tree_, std::move(positions)).without(isLeftOut_);
  }

  /// Returns a caster for the same positions without the triangles for which `isLeftOut` is set, one entry for each.
  /// Where it is null, the caster has all of them. O(1).
  [[nodiscard]] RayCaster without(std::shared_ptr<const std::vector<char>> isLeftOut) const
  {
    RayCaster some(*this);
    some.isLeftOut_ = std::move(isLeftOut);
    return some;
  }
  [[nodiscard]] bool isLeftOut(Index triangle) const { return isLeftOut_ && (*isLeftOut_)[triangle] != 0; }

  [[nodiscard]] const Positions& positions() const noexcept { return *positions_; }

  /// Makes the boxes, which the first ray makes otherwise. It may run on any thread, and serves all copies. O(T).
  void prepare() const { static_cast<void>(boxes_->get(*tree_, *positions_)); }

  /// Returns the first triangle that the ray meets within `range`. Of several at one place it is that of smallest id.
  /// About O(log T).
  [[nodiscard]] std::optional<RayHit> firstHit(const Ray& ray, const RayRange& range = {}) const;

  /// Tells whether the ray meets a triangle at `from` <= t < `before`. It does not count those that are `ignored`,
  /// which ascend. About O(log T).
  [[nodiscard]] bool isBlocked(const Ray& ray, double before, std::span<const Index> ignored, double from = 0) const;

  /// Returns where a plane through `origin`, across `normal` (not zero), cuts the triangles. Each triangle that has
  /// corners on both sides has a segment. About O(segments log T).
  [[nodiscard]] std::vector<std::array<Vector3, 2>> cutBy(const Vector3& origin, const Vector3& normal) const;

  /// Returns all triangles that have a point within reach of the ray, and some that almost have, ascending.
  [[nodiscard]] std::vector<Index> withinReach(const Ray& ray, const RayReach& reach) const;

 private:
  class Caster;

  /// The boxes of a tree are made when they are first asked for, once, whatever threads ask.
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

  /// Visits as `TriangleTree::visit` does, without what is left out.
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
