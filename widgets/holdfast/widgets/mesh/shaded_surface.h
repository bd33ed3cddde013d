#pragma once
/// A mesh cut along its sharp edges for drawing: smooth within, crisp between.

#include <array>
#include <vector>

#include <holdfast/deform/model.h>

namespace holdfast {

/// Triangles over points for drawing. The corners at a vertex share one point as long as no sharp edge parts them.
struct ShadedSurface {
  Polygons triangles;                         ///< over points
  std::vector<Index> vertexOf;                ///< file vertex of each point
  std::vector<Triangle> across;               ///< beyond each side of each triangle: another one; -1: none, or several
  std::vector<std::array<Index, 2>> creases;  ///< points at the ends of sharp edges and of borders that are drawn
  std::vector<std::array<Index, 2>> creaseSides;  ///< each crease with each triangle at it

  /// The first point of each of `vertexCount` file vertices, -1 where no triangle uses it. O(points).
  [[nodiscard]] std::vector<Index> pointOf(Index vertexCount) const;

  /// The creases at the triangles that are left without those for which `isHidden`, one for each. O(creases).
  [[nodiscard]] std::vector<std::array<Index, 2>> creasesWithout(const std::vector<char>& isHidden) const;
};

/// Edges are sharp where the normals on both sides differ by more than this at rest.
inline constexpr double kSharpDegrees = 42;

/// A share of the bounding box's diagonal: shorter lines of sharp edges that close no loop are not drawn.
inline constexpr double kLeastCreaseLength = 0.1;

/// The triangles of `model`, cut along the edges that are sharp at rest, so that the cuts stay while the mesh deforms.
/// Edges of more or fewer than two triangles, or of two that disagree on which side is out, are sharp. O(T log T).
[[nodiscard]] ShadedSurface cutAtSharpEdges(const Model& model);

}  // namespace holdfast
