#pragma once
/// Text meshes out again: the file's own text with other positions.

#include <string>
#include <vector>

#include <holdfast/io/mesh_document.h>
#include <holdfast/io/text/text_cursor.h>

namespace holdfast {

/// Where a text says what may change.
struct TextLayout {
  std::string extension;
  TextDialect dialect;
  std::vector<std::size_t> vertexOffsets;  ///< of each vertex: before its three numbers
  std::vector<std::size_t> normalOffsets;  ///< of each stored normal: before its three numbers
  std::vector<Index> normalOfCorner;       ///< of each corner of the faces: its normal, or -1
  std::vector<std::string> extras;         ///< see `MeshSource::extras`
};

/// The source of a document whose text is `bytes` and whose mesh is `rest`.
[[nodiscard]] std::shared_ptr<const MeshSource> makeTextSource(std::string bytes, TextLayout layout, Mesh rest);

}  // namespace holdfast
