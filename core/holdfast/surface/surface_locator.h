#pragma once
/// \file
/// From the user's names of surface points to canonical ones.

#include <optional>
#include <string>
#include <vector>

#include <holdfast/base/error.h>
#include <holdfast/mesh/edges.h>
#include <holdfast/surface/closest_point.h>
#include <holdfast/surface/surface_location.h>

namespace holdfast {

/// Locates points on one mesh. What several points share (edges, the tree of closest points) is made when the first one
/// asks for it.
class SurfaceLocator {
 public:
  /// Both stay alive as long as the locator. Positions are finite.
  SurfaceLocator(const Mesh& mesh, const Triangulation& triangulation) : mesh_(mesh), triangulation_(triangulation) {}

  struct Located {
    SurfacePoint point;
    double distance = 0;  ///< of a `near` place from the surface, model units; else 0
  };

  /// Throws `InputError` at `where`, its element followed by the key at fault (".vertex", ".edge[0]", ".weights"): ids
  /// out of range, an edge that no face has, as many weights as the face has no corners. O(log T) after O(T log T).
  [[nodiscard]] Located locate(const SurfaceLocation& location, const InputLocation& where);

  /// Whether a face has an edge between the vertices, or is cut in triangles along it. O(log T) after O(T log T).
  [[nodiscard]] bool isEdge(Index i, Index j);

 private:
  [[nodiscard]] Located at(const AtVertex& vertex, const InputLocation& where) const;
  [[nodiscard]] Located at(const AtEdge& edge, const InputLocation& where);
  [[nodiscard]] Located at(const AtFace& face, const InputLocation& where) const;
  [[nodiscard]] Located at(const AtNear& near, const InputLocation& where);

  const Mesh& mesh_;
  const Triangulation& triangulation_;
  std::optional<ClosestPointSearch> search_;
  std::vector<HalfEdge> halfEdges_;
};

/// Throws `InputError` at `where`, its element followed by `key`, unless the mesh has the vertex.
void requireVertex(const Mesh& mesh, Index vertex, const InputLocation& where, const std::string& key);

/// `where` with `key` after its element.
[[nodiscard]] InputLocation below(const InputLocation& where, const std::string& key);

}  // namespace holdfast
