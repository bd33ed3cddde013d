#pragma once
/// \file
/// PLY in, text and binary of either byte order.

#include <string>

#include <holdfast/io/mesh_document.h>

namespace holdfast {

/// Reads a PLY file; `file` names it in errors. The element `vertex` with x, y, z and the element `face` with the list
/// `vertex_indices` (or `vertex_index`) make the mesh; everything else is kept. Where there are no faces, they are the
/// triangles of the element `tristrips`, whose lists are strips separated by -1: corners k, k + 1, k + 2 of a strip
/// are a triangle, every second one turned round, and no face where two of them are the same vertex. Throws
/// `InputError` with the line (text) or the byte (binary).
[[nodiscard]] MeshDocument readPly(std::string bytes, const std::string& file);

}  // namespace holdfast
