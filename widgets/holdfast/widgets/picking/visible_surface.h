#pragma once
/// This class knows which parts of a model's surface are visible.

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

/// The triangles of one model at some positions, hit by rays. A surface never changes, and copies share its data.
///
///     auto surface = std::make_shared<const VisibleSurface>(model);
///     const auto positions = std::make_shared<const Positions>(result.positions);
///     surface = std::make_shared<const VisibleSurface>(surface->movedTo(positions));
///     point->SetSurface(surface);  // vtkHoldfastSurfacePointWidget
class VisibleSurface {
 public:
  /// Makes the surface at rest. `model` must stay alive as long as the surface. O(T log T).
  explicit VisibleSurface(const Model& model);

  /// Returns the same surface without what a plane cuts away. That part is neither hit nor seen, and hides nothing.
  /// Without a plane it is the whole surface. O(1).
  [[nodiscard]] VisibleSurface withSection(const std::optional<SectionPlane>& section) const;
  [[nodiscard]] const std::optional<SectionPlane>& section() const noexcept { return section_; }

  /// Returns the same surface without the hidden triangles. `isHidden` has one entry for each triangle. Null hides
  /// none. O(1).
  [[nodiscard]] VisibleSurface withHidden(std::shared_ptr<const std::vector<char>> isHidden) const;
  [[nodiscard]] bool isHidden(Index triangle) const { return rays_.isLeftOut(triangle); }
  /// Tells whether a triangle at a vertex of the file is not hidden.
  [[nodiscard]] bool isShown(Index vertex) const;

  /// Returns the same surface at other positions, which are all finite. The same plane cuts it, and the same triangles
  /// are hidden. O(1).
  [[nodiscard]] VisibleSurface movedTo(std::shared_ptr<const Positions> positions) const;

  /// Does the work that the first ray would do otherwise. Any thread may call it. O(T).
  void prepare() const { rays_.prepare(); }

  /// Tells whether one surface was made of the other, or both of a third. Places then have the same names on both.
  [[nodiscard]] bool isSameMesh(const VisibleSurface& other) const noexcept
  {
    return trianglesOf_ == other.trianglesOf_;
  }

  [[nodiscard]] const Model& model() const noexcept { return *model_; }
  [[nodiscard]] const Positions& positions() const noexcept { return rays_.positions(); }

  /// Returns the triangles at a vertex of the file and at all vertices of the same unknown, ascending.
  [[nodiscard]] std::span<const Index> trianglesAt(Index vertex) const
  {
    return (*trianglesOf_)[model_->solverMesh.weld.unknownOf[vertex]];
  }

  /// Returns the lines along which the section plane cuts the triangles that are not hidden, a segment for each.
  /// Without a plane there are none.
  [[nodiscard]] std::vector<std::array<Vector3, 2>> cut() const
  {
    if (!section_) return {};
    return rays_.cutBy(section_->origin, section_->normal);
  }

  /// Tells whether a place is not cut away.
  [[nodiscard]] bool isKept(const Vector3& place) const { return !section_ || holdfast::isKept(*section_, place); }
  /// Returns the part of a ray within `range` that is not cut away.
  [[nodiscard]] RayRange keptPart(const Ray& ray, const RayRange& range = {}) const;

  /// Returns the first hit of a ray on what is neither hidden nor cut away.
  [[nodiscard]] std::optional<RayHit> firstHit(const Ray& ray) const { return rays_.firstHit(ray, keptPart(ray)); }

  /// Returns all triangles within reach of a ray, and some that almost are (`RayCaster::withinReach`). Triangles that
  /// are cut away count as well.
  [[nodiscard]] std::vector<Index> withinReach(const Ray& ray, const RayReach& reach) const
  {
    return rays_.withinReach(ray, reach);
  }

  /// Tells whether a vertex in front of the eye is kept, and nothing but its own triangles lies before it.
  [[nodiscard]] bool isVertexVisible(Index vertex, const DisplayTransform& display) const;

  /// Tells the same of a place on the edge between two vertices. The place is kept.
  [[nodiscard]] bool isEdgeVisible(Index i, Index j, const Vector3& place, const DisplayTransform& display) const;

 private:
  [[nodiscard]] bool isBlocked(const Ray& toPlace, std::span<const Index> own) const;

  const Model* model_;
  RayCaster rays_;
  std::shared_ptr<const IndexLists> trianglesOf_;  // of each unknown
  std::optional<SectionPlane> section_;
};

}  // namespace holdfast
