#pragma once
/// These functions read surfaces of VTK from XML PolyData (.vtp) and write them as .vtp or as legacy PolyData (.vtk).
/// Doubles keep every bit.

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <vtkPolyData.h>

#include <holdfast/io/mesh_document.h>
#include <holdfast/mesh/field.h>
#include <holdfast/mesh/mesh.h>

namespace holdfast {

/// Reads a .vtp file. Its polygons and, after them, the triangles of its strips are the faces. Vertices, lines and all
/// arrays are kept for writing. Throws `InputError` where the file is missing, truncated or malformed, or has no faces.
///
///     const MeshDocument document = readPolyData("part.vtp");
///     const Model model = makeModelOfFile(document, "part.vtp");
///     const DeformResult result = deform(model, constraints);
[[nodiscard]] MeshDocument readPolyData(const std::filesystem::path& path);

/// Returns the contents of a file with other `positions` (vertexCount x 3). `extension` names the format, .vtp or .vtk.
/// A document from `readPolyData` keeps its arrays and its compression. Where nothing moved, the result is the file as
/// it was read. Of other documents only positions and faces are written, and a note says so. Throws `OutputError`.
///
///     const Serialized file = serializePolyData(document, result.positions, ".vtp");
///     for (const std::string& note : file.notes) std::cerr << note << '\n';
///     std::ofstream("deformed.vtp", std::ios::binary) << file.bytes;
[[nodiscard]] Serialized serializePolyData(const MeshDocument& document, const Positions& positions,
                                           std::string_view extension);

/// Returns the contents of an XML file. Its arrays follow the XML as raw binary. Where `compressor` names a class of
/// VTK, that class compresses them. The same data give the same bytes. Throws `OutputError`.
[[nodiscard]] std::string vtpBytes(vtkPolyData& polyData, std::string_view compressor = "");

/// Returns the contents of a .vtp file: the faces of `mesh` at `positions` (vertexCount x 3), and the fields as arrays
/// of doubles. Doubles are written bit for bit. Throws `OutputError`.
[[nodiscard]] Serialized fieldsToVtp(const Mesh& mesh, const Positions& positions, std::span<const Field> pointFields,
                                     std::span<const Field> faceFields);

/// Corrects the stored normals of `polyData` where a vertex that they depend on moved. The polygons and points of
/// `polyData` are `rest`. Each new normal is area-weighted and lies on the side of the stored one. Returns a note for
/// each array that changed. O(corners).
[[nodiscard]] std::vector<std::string> refreshNormals(vtkPolyData& polyData, const Mesh& rest,
                                                      const Positions& positions);

}  // namespace holdfast
