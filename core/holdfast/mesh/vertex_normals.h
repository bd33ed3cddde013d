#pragma once
/// Normals of polygons, of vertices, and of groups of corners that share one.

#include <span>
#include <vector>

#include <holdfast/mesh/mesh.h>

namespace holdfast {

/// Half the sum of p_i x p_(i+1) around `polygon`: its length is the area, its direction the normal by the right-hand
/// rule. For a polygon that is not flat, that of its best-fitting plane; zero for fewer than three corners.
[[nodiscard]] Vector3 areaVector(const Positions& positions, std::span<const int> polygon);

/// `vector` at unit length; zero where its length is zero or not finite.
[[nodiscard]] Vector3 unitOrZero(const Vector3& vector);

/// Normals of the same faces for changing positions: row n is the sum of the area vectors of the faces at those corners
/// that `normalOfCorner` (one entry a corner of `faces`, -1 for none) gives the number n, made a unit vector; zero
/// where it vanishes or is not finite. Over threads, with the same bits for any number of them.
class AreaWeightedNormals {
 public:
  /// For `count` normals; `faces` are to outlive it. O(corners).
  AreaWeightedNormals(const Polygons& faces, std::span<const int> normalOfCorner, Index count);

  /// What it returns is overwritten by the next call. O(corners).
  const Positions& at(const Positions& positions);

 private:
  const Polygons& faces_;
  std::vector<int> start_;   ///< of each normal, and the end: its first place in `faceOf_`
  std::vector<int> faceOf_;  ///< the faces of each normal, one for each of their corners
  Positions areas_;          ///< the area vector of each face
  Positions normals_;
};

/// The same for positions that do not change.
[[nodiscard]] Positions areaWeightedNormals(const Positions& positions, const Polygons& faces,
                                            std::span<const int> normalOfCorner, Index count);

}  // namespace holdfast
