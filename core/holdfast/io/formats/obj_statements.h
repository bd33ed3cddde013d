#pragma once
/// These functions know the statements of an OBJ file: which are kept as text, how they go over several lines, and
/// where faces name normals.

#include <holdfast/io/formats/formats.h>

namespace holdfast {

/// '#' begins a comment. '\\' at the end of a line continues it.
inline constexpr TextDialect kObjDialect{'#', '\\'};

[[nodiscard]] inline bool isObjFace(std::string_view keyword)
{
  return keyword == "f" || keyword == "fo";
}

/// Returns what a statement that is kept as text is for, in the words of `MeshSource::extras`. Returns an empty text
/// for a statement that OBJ does not have.
[[nodiscard]] std::string_view purposeOfObjStatement(std::string_view keyword);

/// Goes behind a statement that is kept as text and whose keyword was read. Names in it may end in a backslash.
void skipObjStatement(TextCursor& cursor, std::string_view keyword);

/// Returns what `FileLayout::referencesIn` returns for OBJ. O(size of the text).
[[nodiscard]] std::vector<NormalReference> normalReferencesOfObj(std::string_view bytes);

}  // namespace holdfast
