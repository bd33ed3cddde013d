#pragma once
/// A file may state what is no part of the surface. That is faces of fewer than three corners, and vertices that no
/// face of the surface uses and whose coordinates are not finite. Both are kept in files. Nothing is computed with
/// them.

#include <vector>

#include <holdfast/mesh/mesh.h>

namespace holdfast {

/// Returns the faces of fewer than three corners, ascending. O(F).
[[nodiscard]] std::vector<Index> facesWithoutSurface(const Polygons& faces);

/// Returns the mesh without those faces. O(N + corners).
[[nodiscard]] Mesh surfaceOf(const Mesh& mesh);

/// These vertices have a coordinate that is NaN or infinite. A face of the surface uses those in `ofSurface`, and none
/// uses those in `unused`. Ids ascend.
struct NonFiniteVertices {
  std::vector<Index> ofSurface;
  std::vector<Index> unused;
};

/// Returns the vertices of `mesh` that are not finite. O(N + corners).
[[nodiscard]] NonFiniteVertices nonFiniteVertices(const Mesh& mesh);

/// Returns `positions` with the rows of `stated` that are not finite put in their places, bit for bit. O(N).
[[nodiscard]] Positions withStatedPlaces(const Positions& stated, Positions positions);

}  // namespace holdfast
