#pragma once
/// The solver and the closest-point search see triangles in place of polygons. Files keep their polygons.

#include <array>
#include <vector>

#include <holdfast/mesh/mesh.h>

namespace holdfast {

/// Three vertex ids, in the orientation of the face. They have 32 bits, as all ids that a large mesh has many of.
using Triangle = std::array<int, 3>;

/// The triangles of all faces. The triangles of one face follow one another, and faces are in file order.
struct Triangulation {
  std::vector<Triangle> triangles;            ///< vertex ids
  std::vector<std::array<Index, 3>> corners;  ///< see `cornersOf`; empty where no face has more than three corners
  std::vector<int> faceOf;                    ///< the file face of each triangle

  /// Returns the corners of a triangle, as numbers of corners within its face.
  [[nodiscard]] std::array<Index, 3> cornersOf(Index triangle) const
  {
    return corners.empty() ? std::array<Index, 3>{0, 1, 2} : corners[static_cast<std::size_t>(triangle)];
  }
};

/// Triangulates every face without new vertices. A face of n corners becomes n - 2 triangles, and none where it has
/// fewer than three. Of the ears that can be cut off, the best shaped goes first. A polygon that winds about itself or
/// has no area falls back to whatever ears are left. O(n log n) in the corners of one face, for polygons that do not
/// wind about themselves.
[[nodiscard]] Triangulation triangulate(const Mesh& mesh);

}  // namespace holdfast
