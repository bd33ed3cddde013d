#pragma once
/// \file
/// Numbers over a mesh as a file that viewers (ParaView and others) open: XML PolyData, .vtp.

#include <span>
#include <string>
#include <vector>

#include <holdfast/io/mesh_document.h>

namespace holdfast {

/// One array over the points or the faces of a mesh.
struct Field {
  std::string name;            ///< unique among its kind, not empty
  Index components = 1;        ///< numbers a point or face: 1 for scalars, 3 for vectors
  std::vector<double> values;  ///< those of one point or face side by side: `components` times their count
};

/// The faces of `mesh` at `positions` (vertexCount x 3) with arrays of doubles, all in binary: every bit is kept, NaN
/// included. The same bytes on every run. Throws `OutputError` where VTK fails.
[[nodiscard]] Serialized fieldsToVtp(const Mesh& mesh, const Positions& positions, std::span<const Field> pointFields,
                                     std::span<const Field> faceFields);

}  // namespace holdfast
