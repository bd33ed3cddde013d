#pragma once
/// \file
/// What of a model's surface can be seen from where.

#include <optional>
#include <span>
#include <vector>

#include <holdfast/deform/model.h>
#include <holdfast/mesh/vertex_triangles.h>
#include <holdfast/surface/ray_caster.h>
#include <holdfast/view/display_transform.h>

namespace holdfast {

/// The triangles of one model at its present positions, hit by rays. Triangles are numbered as in the model's
/// triangulation.
class VisibleSurface {
 public:
  /// At rest. `model` stays alive as long as this. O(T log T).
  explicit VisibleSurface(const Model& model);

  /// One row for each vertex of the file, all finite. O(T).
  void setPositions(const Positions& positions) { rays_.setPositions(positions); }
  [[nodiscard]] const Positions& positions() const noexcept { return rays_.positions(); }

  /// The triangles at a vertex of the file and at all that are the same unknown; ascending, none for a vertex that no
  /// face uses.
  [[nodiscard]] std::span<const Index> trianglesAt(Index vertex) const;

  [[nodiscard]] std::optional<RayHit> firstHit(const Ray& ray) const { return rays_.firstHit(ray); }

  [[nodiscard]] std::vector<Index> withinReach(const Ray& ray, const RayReach& reach) const
  {
    return rays_.withinReach(ray, reach);
  }

  /// Whether nothing but its own triangles lies before a vertex that is in front of the eye. Takes microseconds.
  [[nodiscard]] bool isVertexVisible(Index vertex, const DisplayTransform& display) const;

  /// Whether nothing but the triangles of the edge between two vertices lies before a place on it in front of the eye.
  [[nodiscard]] bool isEdgeVisible(Index i, Index j, const Vector3& place, const DisplayTransform& display) const;

 private:
  const Model& model_;
  RayCaster rays_;
  VertexTriangles trianglesOf_;  // of each unknown
};

}  // namespace holdfast
