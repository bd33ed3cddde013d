#pragma once
/// Makes canonical surface points of the user's names for them.

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <holdfast/base/error.h>
#include <holdfast/mesh/edges.h>
#include <holdfast/surface/closest_point.h>
#include <holdfast/surface/surface_location.h>

namespace holdfast {

/// What the points of one mesh share: made when it is first asked for, once, whatever threads ask.
class SurfaceIndex {
 public:
  [[nodiscard]] const ClosestPointSearch& closest(const Mesh& mesh, const Triangulation& triangulation);
  [[nodiscard]] const std::vector<HalfEdge>& halfEdges(const Triangulation& triangulation);

 private:
  std::once_flag hasClosest_;
  std::once_flag hasHalfEdges_;
  std::optional<ClosestPointSearch> closest_;
  std::vector<HalfEdge> halfEdges_;
};

/// Locates points on one mesh. Copies are cheap and share the index. `Model::locator` has the one of a model.
class SurfaceLocator {
 public:
  /// Mesh and triangulation stay alive as long as the locator. Positions are finite.
  SurfaceLocator(const Mesh& mesh, const Triangulation& triangulation,
                 std::shared_ptr<SurfaceIndex> index = std::make_shared<SurfaceIndex>())
      : mesh_(mesh), triangulation_(triangulation), index_(std::move(index))
  {
  }

  /// Throws `InputError` at `where`, its element followed by the key at fault (".vertex", ".edge[0]", ".weights"): ids
  /// out of range, an edge that no face has, as many weights as the face has no corners. O(log T) after O(T log T).
  [[nodiscard]] SurfacePoint locate(const SurfaceLocation& location, const InputLocation& where) const;

  /// Whether a face has an edge between the vertices, or is cut in triangles along it. O(log T) after O(T log T).
  [[nodiscard]] bool isEdge(Index i, Index j) const;

  /// O(log T) after O(T log T).
  [[nodiscard]] ClosestPointSearch::Result closestTo(const Vector3& place) const
  {
    return index_->closest(mesh_, triangulation_).find(place);
  }

 private:
  [[nodiscard]] SurfacePoint at(const AtVertex& vertex, const InputLocation& where) const;
  [[nodiscard]] SurfacePoint at(const AtEdge& edge, const InputLocation& where) const;
  [[nodiscard]] SurfacePoint at(const AtFace& face, const InputLocation& where) const;
  [[nodiscard]] SurfacePoint at(const AtNear& near, const InputLocation& where) const;

  const Mesh& mesh_;
  const Triangulation& triangulation_;
  std::shared_ptr<SurfaceIndex> index_;
};

/// Throws `InputError` at `where`, its element followed by `key`, unless a mesh of so many vertices has the vertex.
void requireVertex(Index vertexCount, Index vertex, const InputLocation& where, const std::string& key);

/// `where` with `key` after its element.
[[nodiscard]] InputLocation below(const InputLocation& where, const std::string& key);

}  // namespace holdfast
