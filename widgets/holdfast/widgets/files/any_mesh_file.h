#pragma once
/// Mesh files of every format that is known where VTK is: the core's and VTK's.

#include <filesystem>
#include <string_view>
#include <vector>

#include <holdfast/io/mesh_document.h>

namespace holdfast {

/// The formats that are read and written, lower case with the dot, the core's first.
[[nodiscard]] std::vector<std::string_view> anyMeshExtensions();
/// The same and legacy VTK (.vtk), which is written only.
[[nodiscard]] std::vector<std::string_view> anyOutputExtensions();

/// As `readMesh` or `readPolyData`, by the extension (any case).
[[nodiscard]] MeshDocument readAnyMesh(const std::filesystem::path& path);

/// As `serializeMesh` or `serializePolyData`, by the extension of `path` (any case), which errors name.
[[nodiscard]] Serialized serializeAnyMesh(const MeshDocument& document, const Positions& positions,
                                          const std::filesystem::path& path);

}  // namespace holdfast
