#pragma once
/// \file
/// STL out again: the file's own bytes with other positions.

#include <string>
#include <vector>

#include <holdfast/io/mesh_document.h>

namespace holdfast {

/// The source of a binary STL file. Positions are rounded to single precision, and a note says what that loses.
[[nodiscard]] std::shared_ptr<const MeshSource> makeBinaryStlSource(std::string bytes, Positions rest);

/// The source of a text STL file, which holds doubles as well as any text; `vertexOffsets` are the places behind each
/// word "vertex", `normalOffsets` those behind each "normal", one a facet.
[[nodiscard]] std::shared_ptr<const MeshSource> makeTextStlSource(std::string bytes,
                                                                  std::vector<std::size_t> vertexOffsets,
                                                                  std::vector<std::size_t> normalOffsets,
                                                                  Positions rest);

}  // namespace holdfast
