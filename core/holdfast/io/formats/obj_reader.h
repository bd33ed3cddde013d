#pragma once
/// \file
/// Wavefront OBJ in.

#include <string>

#include <holdfast/io/mesh_document.h>

namespace holdfast {

/// Reads the text of an OBJ file; `file` names it in errors. Polygons (`f`) make the mesh; everything else is kept as
/// text. Throws `InputError` with the line.
[[nodiscard]] MeshDocument readObj(std::string bytes, const std::string& file);

}  // namespace holdfast
