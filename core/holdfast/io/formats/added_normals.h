#pragma once
/// Lines for the normals that a file gets besides its own, and the references to them.

#include <holdfast/io/formats/stored_normals.h>

namespace holdfast {

/// `replacement` takes the place of `size` bytes from `offset` on.
struct TextEdit {
  std::size_t offset = 0;
  std::size_t size = 0;
  std::string replacement;
};

/// What puts `update.added` into the text, in ascending order. A line for a normal stands behind the last one that
/// precedes the first face with it. References count on over new lines above them, so that those of all other corners
/// name what they named before. Nothing where none was added, else O(size of the text).
[[nodiscard]] std::vector<TextEdit> editsOfReferences(std::string_view bytes, const FileLayout& layout,
                                                      const NormalUpdate& update);

}  // namespace holdfast
