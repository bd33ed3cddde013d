#pragma once
/// A locator finds points of a surface by the user's names for them, and closest to places in space. It also names them
/// in another way.

#include <array>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <holdfast/mesh/edges.h>
#include <holdfast/surface/surface_location.h>
#include <holdfast/surface/surface_point.h>
#include <holdfast/surface/triangle_tree.h>
#include <holdfast/words/error.h>

namespace holdfast {

/// A triangle point has weights of the triangle's corners. None is negative, and their sum is 1. They are exact zeros
/// on edges and vertices.
struct TrianglePoint {
  std::array<double, 3> weights{};
  Vector3 position = Vector3::Zero();
  double squaredDistance = 0;
};

/// Returns the point of a triangle that is closest to `place`. Triangles may be segments or points. Fourth powers of
/// lengths are taken, so lengths should lie between 1e-70 and 1e70.
[[nodiscard]] TrianglePoint closestPointOfTriangle(const std::array<Vector3, 3>& corners, const Vector3& place);

/// `ClosestPointSearch` finds closest points through a tree of boxes, at any size of the surface.
class ClosestPointSearch {
 public:
  /// Positions must be finite, and there must be at least one triangle. O(T log T).
  ClosestPointSearch(const Positions& positions, const std::vector<Triangle>& triangles);

  struct Result {
    SurfacePoint point;
    Index triangle = 0;
    double distance = 0;  ///< model units
  };

  /// Returns the exact closest point of a finite place. Of triangles at the same distance it takes the one that comes
  /// first.
  [[nodiscard]] Result find(const Vector3& place) const;

 private:
  int exponent_;         // the unit of what follows is 2^exponent model units
  Positions positions_;  // in that unit: squares stay within the range of doubles
  TriangleTree tree_;
  TriangleTree::Boxes boxes_;
};

/// An index holds what the points of one mesh share. Each part is made when it is first asked for, once, whatever
/// threads ask.
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

/// A locator locates points on one mesh, O(log T) after O(T log T). Copies share the index. `Model::locator` has that
/// of a model.
class SurfaceLocator {
 public:
  /// Mesh and triangulation must stay alive as long as the locator. Positions must be finite.
  SurfaceLocator(const Mesh& mesh, const Triangulation& triangulation,
                 std::shared_ptr<SurfaceIndex> index = std::make_shared<SurfaceIndex>())
      : mesh_(mesh), triangulation_(triangulation), index_(std::move(index))
  {
  }

  /// Returns the point that `location` names. Throws `InputError` at `where`, its element followed by the key at fault
  /// (".vertex", ".edge[0]", ".weights"). The faults are ids out of range, an edge that no face has, and another number
  /// of weights than the face has corners.
  [[nodiscard]] SurfacePoint locate(const SurfaceLocation& location, const InputLocation& where) const;

  /// Tells whether a face has an edge between the vertices, or is cut in triangles along it.
  [[nodiscard]] bool isEdge(Index i, Index j) const;

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

/// The kinds are in the order of `SurfaceLocation`.
enum class LocationKind { Vertex, Edge, Face, Near };

[[nodiscard]] inline LocationKind kindOf(const SurfaceLocation& location)
{
  static_assert(std::variant_size_v<SurfaceLocation> == static_cast<std::size_t>(LocationKind::Near) + 1);
  return static_cast<LocationKind>(location.index());
}

/// Returns the point of this kind that is nearest to `location`, by positions at rest. What lies on a vertex or an edge
/// stays there as long as the kind allows it.
/// - A vertex is the nearest end of the location's edge, or the nearest corner of its face.
/// - An edge is, for a vertex, the first edge at it in file order, with t = 1. Else it is the nearest side of the
///   location's face.
/// - A face is the first in file order that has the vertex, or both ends of the edge, with the same weights.
/// - A near point is the location's place.
///
/// `locator` is that of `mesh`. Throws `InputError` as the locator does. Throws one without a place in the input for a
/// vertex that no face uses, or that no edge joins to another. O(corners of the mesh).
[[nodiscard]] SurfaceLocation converted(const SurfaceLocation& location, LocationKind kind, const Mesh& mesh,
                                        const SurfaceLocator& locator);

/// Throws `InputError` at `where`, its element followed by `key`, unless a mesh of so many vertices has the vertex.
void requireVertex(Index vertexCount, Index vertex, const InputLocation& where, const std::string& key);

/// Throws the same error where `vertex` is one of those of `SolverMesh::withoutPlace`, which are ascending.
void requirePlace(const std::vector<Index>& withoutPlace, Index vertex, const InputLocation& where,
                  const std::string& key);

/// Returns `where` with `key` after its element.
[[nodiscard]] InputLocation below(const InputLocation& where, const std::string& key);

}  // namespace holdfast
