#pragma once
/// These edits add lines for the normals that a file gets besides its own, and set the references to them.

#include <holdfast/io/formats/stored_normals.h>
#include <holdfast/io/formats/text_edit.h>

namespace holdfast {

/// Returns the edits that put `update.added` into the text, in ascending order. The line of an added normal stands
/// behind the last line of a normal before the first face with it. References count on over new lines above them, so
/// that those of all other corners name what they named before. Returns nothing where no normal was added. Otherwise it
/// costs O(size of the text).
[[nodiscard]] std::vector<TextEdit> editsOfReferences(std::string_view bytes, const FileLayout& layout,
                                                      const NormalUpdate& update);

}  // namespace holdfast
