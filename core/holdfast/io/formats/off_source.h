#pragma once
/// \file
/// Object File Format out again: the file's own text with other positions.

#include <string>
#include <vector>

#include <holdfast/io/mesh_document.h>
#include <holdfast/io/text/text_cursor.h>

namespace holdfast {

/// '#' begins a comment.
inline constexpr TextDialect kOffDialect{'#', std::nullopt};

/// What stands on the line of a vertex behind its position.
struct OffVertexForm {
  bool hasNormals = false;
  bool hasColors = false;   ///< three or four numbers
  bool hasTexture = false;  ///< two numbers
  bool isColorBeforeNormal = false;

  /// The fewest numbers on the line of a vertex; with colours there may be one more.
  [[nodiscard]] Index leastColumns() const noexcept
  {
    return 3 + (hasNormals ? 3 : 0) + (hasColors ? 3 : 0) + (hasTexture ? 2 : 0);
  }
};

/// Where an OFF file says what may change.
struct OffLayout {
  OffVertexForm form;
  std::size_t vertexOffset = 0;     ///< somewhere before the first vertex, behind the counts
  std::vector<std::string> extras;  ///< see `MeshSource::extras`
};

/// The source of a document whose text is `bytes` and whose mesh is `rest`.
[[nodiscard]] std::shared_ptr<const MeshSource> makeOffSource(std::string bytes, OffLayout layout, Mesh rest);

}  // namespace holdfast
