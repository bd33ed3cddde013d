#pragma once
/// Which parts of a model's surface are visible.

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <holdfast/deform/model.h>
#include <holdfast/mesh/index_lists.h>
#include <holdfast/surface/ray_caster.h>
#include <holdfast/widgets/camera/display_transform.h>
#include <holdfast/widgets/mesh/section_plane.h>

namespace holdfast {

/// The triangles of one model at some positions, hit by rays. Never changes; copies share its data.
class VisibleSurface {
 public:
  /// At rest. `model` stays alive as long as this. O(T log T).
  explicit VisibleSurface(const Model& model);

  /// The same without what a plane cuts away, which is neither hit nor seen, and hides nothing; none: all of it. O(1).
  [[nodiscard]] VisibleSurface withSection(const std::optional<SectionPlane>& section) const;
  [[nodiscard]] const std::optional<SectionPlane>& section() const noexcept { return section_; }

  /// The same without the triangles for which `isHidden`, one for each; null: with all of them. O(1).
  [[nodiscard]] VisibleSurface withHidden(std::shared_ptr<const std::vector<char>> isHidden) const;
  [[nodiscard]] bool isHidden(Index triangle) const { return rays_.isLeftOut(triangle); }
  /// Whether a triangle at a vertex of the file is not hidden.
  [[nodiscard]] bool isShown(Index vertex) const;

  /// The same at other positions, all finite, cut by the same plane, as much hidden. O(1).
  [[nodiscard]] VisibleSurface movedTo(std::shared_ptr<const Positions> positions) const;

  /// Does what the first ray does otherwise, on any thread. O(T).
  void prepare() const { rays_.prepare(); }

  /// Whether one was made of the other, or both of a third: places are named alike on both.
  [[nodiscard]] bool isSameMesh(const VisibleSurface& other) const noexcept
  {
    return trianglesOf_ == other.trianglesOf_;
  }

  [[nodiscard]] const Model& model() const noexcept { return *model_; }
  [[nodiscard]] const Positions& positions() const noexcept { return rays_.positions(); }

  /// The triangles at a vertex of the file and at all that are the same unknown; ascending.
  [[nodiscard]] std::span<const Index> trianglesAt(Index vertex) const
  {
    return (*trianglesOf_)[model_->solverMesh.weld.unknownOf[vertex]];
  }

  /// Where the section plane cuts the triangles that are not hidden, a segment each; none without a plane.
  [[nodiscard]] std::vector<std::array<Vector3, 2>> cut() const
  {
    if (!section_) return {};
    return rays_.cutBy(section_->origin, section_->normal);
  }

  /// Whether a place is not cut away.
  [[nodiscard]] bool isKept(const Vector3& place) const { return !section_ || holdfast::isKept(*section_, place); }
  /// The part of a ray within `range` that is not cut away.
  [[nodiscard]] RayRange keptPart(const Ray& ray, const RayRange& range = {}) const;

  [[nodiscard]] std::optional<RayHit> firstHit(const Ray& ray) const { return rays_.firstHit(ray, keptPart(ray)); }

  /// Those that are cut away as well.
  [[nodiscard]] std::vector<Index> withinReach(const Ray& ray, const RayReach& reach) const
  {
    return rays_.withinReach(ray, reach);
  }

  /// Whether a vertex in front of the eye is kept, and nothing but its own triangles lies before it.
  [[nodiscard]] bool isVertexVisible(Index vertex, const DisplayTransform& display) const;

  /// The same for a place on the edge between two vertices, which is kept.
  [[nodiscard]] bool isEdgeVisible(Index i, Index j, const Vector3& place, const DisplayTransform& display) const;

 private:
  [[nodiscard]] bool isBlocked(const Ray& toPlace, std::span<const Index> own) const;

  const Model* model_;
  RayCaster rays_;
  std::shared_ptr<const IndexLists> trianglesOf_;  // of each unknown
  std::optional<SectionPlane> section_;
};

}  // namespace holdfast
