#pragma once
/// \file
/// The mesh formats of VTK in and out: XML PolyData (.vtp) and legacy PolyData (.vtk).

#include <filesystem>
#include <span>
#include <string_view>

#include <holdfast/io/mesh_document.h>

namespace holdfast {

/// The extensions that `readPolyData` and `serializePolyData` know, lower case with the dot.
[[nodiscard]] std::span<const std::string_view> polyDataExtensions();

/// Reads a surface; the extension (any case) names the format. The polygons are the faces of the mesh; vertices, lines
/// and every array of points, cells and the whole file are kept for writing. Throws `InputError` with the file and
/// VTK's reason where it is missing, truncated or malformed; where it has no polygons; where it has triangle strips.
/// Coordinates of single precision are read as they stand and written as doubles.
[[nodiscard]] MeshDocument readPolyData(const std::filesystem::path& path);

/// The contents of a file of the format named by `extension`, with `positions` (vertexCount x 3) in place of the
/// document's own. A document read from either format of VTK keeps all its arrays in both; of others positions and
/// faces are written, and a note says what was left behind. Always in VTK's binary form: its text does not hold
/// doubles. Throws `OutputError` for an extension that is not known.
[[nodiscard]] Serialized serializePolyData(const MeshDocument& document, const Positions& positions,
                                           std::string_view extension);

}  // namespace holdfast
