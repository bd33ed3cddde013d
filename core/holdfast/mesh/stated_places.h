#pragma once
/// What a file states that is no part of the surface: faces of fewer than three corners, and vertices that no face of
/// the surface uses and whose coordinates are not finite. Both are kept in files; nothing is computed with them.

#include <vector>

#include <holdfast/mesh/mesh.h>

namespace holdfast {

/// The faces of fewer than three corners, ascending. O(F).
[[nodiscard]] std::vector<Index> facesWithoutSurface(const Polygons& faces);

/// The mesh without those faces. O(N + corners).
[[nodiscard]] Mesh surfaceOf(const Mesh& mesh);

/// Vertices with a coordinate that is NaN or infinite, ascending: those that a face of the surface uses, and the
/// others.
struct NonFiniteVertices {
  std::vector<Index> ofSurface;
  std::vector<Index> unused;
};

/// O(N + corners).
[[nodiscard]] NonFiniteVertices nonFiniteVertices(const Mesh& mesh);

/// `positions` with the rows of `stated` that are not finite in their places, bit for bit. O(N).
[[nodiscard]] Positions withStatedPlaces(const Positions& stated, Positions positions);

}  // namespace holdfast
