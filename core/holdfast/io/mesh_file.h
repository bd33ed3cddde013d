#pragma once
/// These functions read and write mesh files. The extension of the name says the format: OBJ, PLY, OFF, STL or VTP.
/// Legacy VTK files (.vtk) are written alone.

#include <filesystem>
#include <span>
#include <string_view>

#include <holdfast/io/mesh_document.h>

namespace holdfast {

/// Returns the extensions that `readMesh` knows, in lower case with the dot.
[[nodiscard]] std::span<const std::string_view> meshExtensions();

/// Returns the extensions that `serializeMesh` knows, in the same way.
[[nodiscard]] std::span<const std::string_view> outputExtensions();

/// Reads a mesh file. The extension, in any case, names the format. Coordinates that are not finite are read as they
/// are. Throws `InputError` where the file is missing, truncated or malformed, or refers to vertices that it does not
/// have. The error has the line (text) or the byte offset (binary). The size of the file bounds the memory, whatever
/// counts its header claims. A file that should be a text and cannot be one is refused before it is read whole.
///
///     const MeshDocument document = readMesh("bracket.ply");
///     const Model model = makeModelOfFile(document, "bracket.ply");
///     const DeformResult result = deform(model, constraints);
///     for (const std::string& note : writeMesh("deformed.ply", document, result.positions)) std::cerr << note << '\n';
[[nodiscard]] MeshDocument readMesh(const std::filesystem::path& path);

/// Returns the contents of a mesh file with `positions` (vertexCount x 3) in place of the document's own. `extension`
/// names the format. In the document's own format all else is kept (`MeshSource::withPositions`). In another one only
/// positions and faces are written, and a note says what is lost. Vertices whose coordinates are not finite in the
/// document keep them. Throws `OutputError` for an extension that is not known, and where a coordinate is too large for
/// the format.
[[nodiscard]] Serialized serializeMesh(const MeshDocument& document, const Positions& positions,
                                       std::string_view extension);

/// Returns the contents of the file `path`, whose extension names the format, as `serializeMesh` does. Throws
/// `OutputError` as it does, with `path` in the place of the extension.
[[nodiscard]] Serialized serializeMeshFile(const MeshDocument& document, const Positions& positions,
                                           const std::filesystem::path& path);

/// Writes what `serializeMeshFile` returns to `path`, whole or not at all. Returns the notes on what could not be kept.
/// Throws `OutputError` as `serializeMeshFile` does, and where the file cannot be written.
std::vector<std::string> writeMesh(const std::filesystem::path& path, const MeshDocument& document,
                                   const Positions& positions);

}  // namespace holdfast
