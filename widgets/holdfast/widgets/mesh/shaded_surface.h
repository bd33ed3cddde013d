#pragma once
/// A mesh is cut along its sharp edges for drawing. It then looks smooth within the parts and crisp between them.

#include <array>
#include <vector>

#include <holdfast/deform/model.h>

namespace holdfast {

/// Triangles over points for drawing. The corners at a vertex share one point as long as no sharp edge parts them.
struct ShadedSurface {
  Polygons triangles;           ///< over points
  std::vector<Index> vertexOf;  ///< the vertex of the file for each point
  /// The triangle beyond each side of each triangle; -1 if there is none, or several.
  std::vector<Triangle> across;
  std::vector<std::array<Index, 2>> creases;  ///< the points at the ends of the sharp edges and borders that are drawn
  std::vector<std::array<Index, 2>> creaseSides;  ///< each crease with each triangle at it

  /// Returns the first point of each of `vertexCount` vertices of the file. It is -1 where no triangle uses the vertex.
  /// O(points).
  [[nodiscard]] std::vector<Index> pointOf(Index vertexCount) const;

  /// Returns the creases that remain without the hidden triangles. `isHidden` has one entry for each triangle.
  /// O(creases).
  [[nodiscard]] std::vector<std::array<Index, 2>> creasesWithout(const std::vector<char>& isHidden) const;
};

/// An edge is sharp if the normals on both sides differ by more than this at rest.
inline constexpr double kSharpDegrees = 42;

/// Shorter lines of sharp edges are not drawn unless they close a loop. The length is a share of the diagonal.
inline constexpr double kLeastCreaseLength = 0.1;

/// Cuts the triangles of `model` along the edges that are sharp at rest, so that the cuts stay while the mesh deforms.
/// An edge of more or fewer than two triangles is sharp. So is an edge of two that disagree on which side is out. O(T
/// log T).
[[nodiscard]] ShadedSurface cutAtSharpEdges(const Model& model);

}  // namespace holdfast
