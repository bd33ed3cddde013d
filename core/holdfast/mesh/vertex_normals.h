#pragma once
/// Polygons and vertices have normals, and so have groups of corners that share one.

#include <span>
#include <vector>

#include <holdfast/mesh/mesh.h>

namespace holdfast {

/// Returns half the sum of p_i x p_(i+1) around `polygon`. Its length is the area, and its direction is the normal by
/// the right-hand rule. For a polygon that is not flat, the normal is that of its best-fitting plane. The vector is
/// zero for fewer than three corners.
[[nodiscard]] Vector3 areaVector(const Positions& positions, std::span<const int> polygon);

/// Returns `vector` at unit length. It is zero where the length of `vector` is zero or not finite.
[[nodiscard]] Vector3 unitOrZero(const Vector3& vector);

/// `AreaWeightedNormals` makes normals of the same faces for changing positions. Row n is the sum of area vectors, made
/// a unit vector. They are those of the faces at the corners to which `normalOfCorner` gives the number n. It has one
/// entry for each corner of `faces`, -1 for none. The row is zero where the sum vanishes or is not finite. The work
/// goes over threads, with the same bits for any number of them.
class AreaWeightedNormals {
 public:
  /// Prepares `count` normals. `faces` must outlive this. O(corners).
  AreaWeightedNormals(const Polygons& faces, std::span<const int> normalOfCorner, Index count);

  /// Returns the normals at `positions`. The next call overwrites them. O(corners).
  const Positions& at(const Positions& positions);

 private:
  const Polygons& faces_;
  std::vector<int> start_;   ///< of each normal, and the end: its first place in `faceOf_`
  std::vector<int> faceOf_;  ///< the faces of each normal, one for each of their corners
  Positions areas_;          ///< the area vector of each face
  Positions normals_;
};

/// Returns the same for positions that do not change.
[[nodiscard]] Positions areaWeightedNormals(const Positions& positions, const Polygons& faces,
                                            std::span<const int> normalOfCorner, Index count);

}  // namespace holdfast
