#pragma once
/// \file
/// PLY out again: the file's own bytes with other positions.

#include <string>

#include <holdfast/io/formats/ply_header.h>
#include <holdfast/io/formats/ply_scanner.h>
#include <holdfast/io/mesh_document.h>

namespace holdfast {

/// The source of a document whose file is `bytes` and whose mesh is `rest`; its rows of vertices begin at `vertices`.
/// The header is read from `bytes` again.
[[nodiscard]] std::shared_ptr<const MeshSource> makePlySource(std::string bytes, PlyPlace vertices, Mesh rest);

}  // namespace holdfast
