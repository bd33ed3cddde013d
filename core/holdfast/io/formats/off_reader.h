#pragma once
/// \file
/// Object File Format (OFF, COFF, NOFF, CNOFF, STOFF and so on) in.

#include <string>

#include <holdfast/io/mesh_document.h>

namespace holdfast {

/// Reads the text of an OFF file, one vertex or face a line; `file` names it in errors. Throws `InputError` with the
/// line.
[[nodiscard]] MeshDocument readOff(std::string bytes, const std::string& file);

}  // namespace holdfast
