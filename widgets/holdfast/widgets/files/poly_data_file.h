#pragma once
/// Surfaces of VTK as files: XML PolyData (.vtp) in and out, legacy PolyData (.vtk) out. Doubles keep every bit.

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

/// Reads a .vtp file: polygons and, after them, triangles of strips are the faces; vertices, lines and all arrays are
/// kept for writing. Throws `InputError` where it is missing, truncated or malformed, or has no faces.
[[nodiscard]] MeshDocument readPolyData(const std::filesystem::path& path);

/// A file of the format that `extension` names, .vtp or .vtk, with other `positions` (vertexCount x 3). Documents from
/// `readPolyData` keep their arrays and compression, and are the file itself where nothing moved; of others positions
/// and faces are written, with a note. Throws `OutputError`.
[[nodiscard]] Serialized serializePolyData(const MeshDocument& document, const Positions& positions,
                                           std::string_view extension);

/// An XML file, arrays as raw binary after the XML, compressed by the class of VTK's of that name, if one is given. The
/// same bytes for the same data. Throws `OutputError`.
[[nodiscard]] std::string vtpBytes(vtkPolyData& polyData, std::string_view compressor = "");

/// The faces of `mesh` at `positions` (vertexCount x 3) with arrays of doubles, bit for bit. Throws `OutputError`.
[[nodiscard]] Serialized fieldsToVtp(const Mesh& mesh, const Positions& positions, std::span<const Field> pointFields,
                                     std::span<const Field> faceFields);

/// Makes the stored normals of `polyData`, whose polygons and points are `rest`, right where a vertex that they depend
/// on moved: area-weighted, on the side of the stored one. Returns a note for each array that changed. O(corners).
[[nodiscard]] std::vector<std::string> refreshNormals(vtkPolyData& polyData, const Mesh& rest,
                                                      const Positions& positions);

}  // namespace holdfast
