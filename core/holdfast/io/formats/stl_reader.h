#pragma once
/// \file
/// STL in, text and binary.

#include <string>

#include <holdfast/io/mesh_document.h>

namespace holdfast {

/// Reads an STL file; `file` names it in errors. Each facet has three vertices of its own, in file order. A file is
/// binary if its size is what the count in its binary header calls for, whatever the first bytes say. Throws
/// `InputError` with the line (text) or the byte (binary).
[[nodiscard]] MeshDocument readStl(std::string bytes, const std::string& file);

}  // namespace holdfast
