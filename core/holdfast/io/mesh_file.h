#pragma once
/// Mesh files in and out: OBJ, PLY, OFF, STL by the extension of the name.

#include <filesystem>
#include <span>
#include <string_view>

#include <holdfast/io/mesh_document.h>

namespace holdfast {

/// The extensions that `readMesh` and `serializeMesh` know, lower case with the dot.
[[nodiscard]] std::span<const std::string_view> meshExtensions();

/// Reads a mesh file; the extension (any case) names the format. `known` are the extensions that the message about
/// another one lists. Throws `InputError` with line (text) or byte offset (binary) where the file is missing,
/// truncated, malformed, or refers to vertices that it does not have. Non-finite coordinates are read as they are.
/// Memory is bounded by the size of the file, whatever counts its header claims. What cannot be a text is refused
/// before it is read whole.
[[nodiscard]] MeshDocument readMesh(const std::filesystem::path& path,
                                    std::span<const std::string_view> known = meshExtensions());

/// The contents of a mesh file of the format named by `extension`, with `positions` (vertexCount x 3) in place of the
/// document's own. In the document's own format all else is kept (`MeshSource::withPositions`); in another one only
/// positions and faces are written, and a note says so. Vertices whose coordinates are not finite in the document keep
/// them. Throws `OutputError` for an extension that is not known.
[[nodiscard]] Serialized serializeMesh(const MeshDocument& document, const Positions& positions,
                                       std::string_view extension);

/// Writes that to `path`, whole or not at all. Returns the notes on what could not be kept. Throws `OutputError`.
std::vector<std::string> writeMesh(const std::filesystem::path& path, const MeshDocument& document,
                                   const Positions& positions);

}  // namespace holdfast
