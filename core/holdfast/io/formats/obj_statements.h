#pragma once
/// The statements of an OBJ file: which are kept as text, how they go over several lines, and where faces name normals.

#include <holdfast/io/formats/formats.h>

namespace holdfast {

/// '#' begins a comment, '\\' at the end of a line continues it.
inline constexpr TextDialect kObjDialect{'#', '\\'};

[[nodiscard]] inline bool isObjFace(std::string_view keyword)
{
  return keyword == "f" || keyword == "fo";
}

/// What a statement that is kept as text is for, in the words of `MeshSource::extras`; empty for one that OBJ does not
/// have.
[[nodiscard]] std::string_view purposeOfObjStatement(std::string_view keyword);

/// Goes behind a statement that is kept as text, whose keyword was read. Names may end in a backslash.
void skipObjStatement(TextCursor& cursor, std::string_view keyword);

/// See `FileLayout::referencesIn`. O(size of the text).
[[nodiscard]] std::vector<NormalReference> normalReferencesOfObj(std::string_view bytes);

}  // namespace holdfast
