#pragma once
/// This function writes fields over a mesh as a file that ParaView and other programs on VTK read.

#include <span>

#include <holdfast/io/mesh_document.h>
#include <holdfast/mesh/field.h>

namespace holdfast {

/// Returns the contents of a .vtp file: the faces of `mesh` at `positions` (vertexCount x 3), and the fields as arrays
/// of doubles. The values of `pointFields` are those of the vertices, the values of `faceFields` those of all faces.
/// Faces of fewer than three corners are left out with their values. Doubles are written bit for bit. The same data
/// give the same bytes. O(bytes).
///
///     const Serialized file = fieldsToVtp(model.mesh, result.positions, fieldsOf(model, result), {});
///     std::ofstream("fields.vtp", std::ios::binary) << file.bytes;
[[nodiscard]] Serialized fieldsToVtp(const Mesh& mesh, const Positions& positions, std::span<const Field> pointFields,
                                     std::span<const Field> faceFields);

}  // namespace holdfast
