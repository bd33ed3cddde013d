#pragma once
/// New values for the normals that a file stores, where the faces around them have moved.

#include <holdfast/io/formats/formats.h>

namespace holdfast {

/// A normal that the file gets besides its own.
struct AddedNormal {
  Vector3 value;
  int of = -1;  ///< the stored normal that its corners named before
};

struct NormalUpdate {
  Positions normals;               ///< one row a stored normal; meaningful where `isNew`
  std::vector<bool> isNew;         ///< the others keep the value in the file
  std::vector<std::string> notes;  ///< how many were recomputed or added, and how many could not be
  std::vector<AddedNormal> added;
  /// Of each corner of the faces: one of `added`, or -1. Empty where none was added.
  std::vector<int> addedOfCorner;
};

/// Area-weighted normals, for those with a moved vertex in one of the faces that use them. Where the area around a
/// normal vanishes, it keeps its old value. In formats with references each vertex gets the normal of the faces around
/// it that shared one there, and corners of faces that rest keep theirs. O(corners), where few share one normal.
[[nodiscard]] NormalUpdate updateNormals(const Mesh& rest, const FileLayout& layout, const Positions& after);

/// Whether the positions of vertex `v` are the same to the last bit.
[[nodiscard]] bool hasSameRow(const Positions& a, const Positions& b, Index v);

}  // namespace holdfast
