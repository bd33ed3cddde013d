#pragma once
/// \file
/// Wavefront OBJ out again: the file's own text with other positions.

#include <string>
#include <vector>

#include <holdfast/io/mesh_document.h>
#include <holdfast/io/text/text_cursor.h>

namespace holdfast {

/// '#' begins a comment, '\' at the end of a line continues it.
inline constexpr TextDialect kObjDialect{'#', '\\'};

/// Where an OBJ file says what may change.
struct ObjLayout {
  std::vector<std::size_t> vertexOffsets;  ///< one a `v`: behind the keyword
  std::vector<std::size_t> normalOffsets;  ///< one a `vn`: behind the keyword
  std::vector<Index> normalOfCorner;       ///< one a corner of the faces: its `vn` from 0, or -1
  std::vector<std::string> extras;         ///< see `MeshSource::extras`
};

/// The source of a document whose text is `bytes` and whose mesh is `rest`.
[[nodiscard]] std::shared_ptr<const MeshSource> makeObjSource(std::string bytes, ObjLayout layout, Mesh rest);

}  // namespace holdfast
