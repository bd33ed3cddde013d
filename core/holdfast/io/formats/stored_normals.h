#pragma once
/// The normals that a file stores get new values where the faces around them have moved.

#include <holdfast/io/formats/formats.h>

namespace holdfast {

/// The file gets this normal besides its own.
struct AddedNormal {
  Vector3 value;
  int of = -1;  ///< the stored normal that its corners named before
};

struct NormalUpdate {
  Positions normals;               ///< one row a stored normal; meaningful where `isNew`
  std::vector<bool> isNew;         ///< the others keep the value in the file
  std::vector<std::string> notes;  ///< how many were recomputed or added, and how many could not be
  std::vector<AddedNormal> added;
  /// Names one of `added` for each corner of the faces, or -1. It is empty where none was added.
  std::vector<int> addedOfCorner;
};

/// Computes area-weighted normals anew where one of the faces that use them has a moved vertex. Where the area around a
/// normal vanishes, it keeps its old value. In formats with references each vertex gets the normal of the faces around
/// it that shared one there. Corners of faces that rest keep theirs. O(corners), where few share one normal.
[[nodiscard]] NormalUpdate updateNormals(const Mesh& rest, const FileLayout& layout, const Positions& after);

/// Tells whether the positions of vertex `v` are the same to the last bit.
[[nodiscard]] bool hasSameRow(const Positions& a, const Positions& b, Index v);

}  // namespace holdfast
