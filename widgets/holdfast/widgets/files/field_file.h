#pragma once
/// \file
/// Numbers over a mesh as a file that viewers (ParaView and others) open: XML PolyData, .vtp.

#include <span>

#include <holdfast/io/mesh_document.h>
#include <holdfast/mesh/field.h>

namespace holdfast {

/// The faces of `mesh` at `positions` (vertexCount x 3) with arrays of doubles, all in binary: every bit is kept, NaN
/// included. The same bytes on every run. Throws `OutputError` where VTK fails.
[[nodiscard]] Serialized fieldsToVtp(const Mesh& mesh, const Positions& positions, std::span<const Field> pointFields,
                                     std::span<const Field> faceFields);

}  // namespace holdfast
