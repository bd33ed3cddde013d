#pragma once
/// The triangles that the solver and the closest-point search see in place of polygons. Files keep their polygons.

#include <array>
#include <vector>

#include <holdfast/mesh/mesh.h>

namespace holdfast {

/// Three vertex ids, in the orientation of the face. In 32 bits, as all ids that a large mesh has many of.
using Triangle = std::array<int, 3>;

/// The triangles of all faces, those of one face side by side, faces in file order.
struct Triangulation {
  std::vector<Triangle> triangles;            ///< vertex ids
  std::vector<std::array<Index, 3>> corners;  ///< see `cornersOf`; empty where no face has more than three corners
  std::vector<int> faceOf;                    ///< file face of each triangle

  /// A triangle as corner numbers within its face.
  [[nodiscard]] std::array<Index, 3> cornersOf(Index triangle) const
  {
    return corners.empty() ? std::array<Index, 3>{0, 1, 2} : corners[static_cast<std::size_t>(triangle)];
  }
};

/// Triangulates every face without new vertices: n - 2 triangles for n corners, none for fewer than three. Of the ears
/// that can be cut off, the best shaped goes first. A polygon that winds about itself or has no area falls back to
/// whatever ears are left. O(n log n) in the corners of one face, for polygons that do not wind about themselves.
[[nodiscard]] Triangulation triangulate(const Mesh& mesh);

}  // namespace holdfast
