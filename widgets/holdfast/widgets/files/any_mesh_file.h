#pragma once
/// These functions read and write mesh files of every format that is known where VTK is: those of the core and those of
/// VTK.

#include <filesystem>
#include <string_view>
#include <vector>

#include <holdfast/io/mesh_document.h>

namespace holdfast {

/// Returns the extensions of the formats that are read and written, in lower case with the dot. Those of the core come
/// first.
[[nodiscard]] std::vector<std::string_view> anyMeshExtensions();
/// Returns the same extensions and that of legacy VTK (.vtk), which is written but not read.
[[nodiscard]] std::vector<std::string_view> anyOutputExtensions();

/// Reads a mesh file as `readMesh` or `readPolyData` does. The extension, in any case, names the format. Throws
/// `InputError` as they do.
///
///     const MeshDocument document = readAnyMesh("part.vtp");
///     const Model model = makeModelOfFile(document, "part.vtp");
///     const DeformResult result = deform(model, readConstraints("points.csv"));
///     const Serialized file = serializeAnyMesh(document, result.positions, "deformed.vtp");
///     std::ofstream("deformed.vtp", std::ios::binary) << file.bytes;
[[nodiscard]] MeshDocument readAnyMesh(const std::filesystem::path& path);

/// Returns the contents of a file as `serializeMesh` or `serializePolyData` does. The extension of `path`, in any case,
/// names the format. Throws `OutputError`, which names `path`.
[[nodiscard]] Serialized serializeAnyMesh(const MeshDocument& document, const Positions& positions,
                                          const std::filesystem::path& path);

}  // namespace holdfast
