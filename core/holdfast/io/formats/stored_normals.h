#pragma once
/// What becomes of the normals that a file stores when some of its vertices move.

#include <span>
#include <string>
#include <vector>

#include <holdfast/mesh/mesh.h>

namespace holdfast {

/// For each vertex, whether its position changed in any bit.
[[nodiscard]] std::vector<bool> movedVertices(const Positions& before, const Positions& after);

/// New values for stored normals.
struct NormalUpdate {
  Positions normals;               ///< one row a stored normal; meaningful where `isNew`
  std::vector<bool> isNew;         ///< the others keep the value in the file
  std::vector<std::string> notes;  ///< how many were recomputed, and how many could not be
};

/// New values for the `count` stored normals of which corner c of `faces` uses `normalOfCorner[c]` (-1 for none):
/// area-weighted, for those with a moved vertex in one of the faces that use them. Where the area around a normal
/// vanishes, it keeps its old value.
[[nodiscard]] NormalUpdate updateNormals(const Polygons& faces, std::span<const Index> normalOfCorner, Index count,
                                         const Positions& before, const Positions& after);

}  // namespace holdfast
