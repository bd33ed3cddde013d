#pragma once
/// A source writes a VTP file again. It copies the bytes that were read, with other numbers in the arrays of points and
/// of stored normals.

#include <memory>
#include <vector>

#include <holdfast/io/formats/vtp_array.h>
#include <holdfast/io/mesh_document.h>

namespace holdfast {

/// A piece of a file tells where its points and polygons are in the mesh. Its elements are those of the file.
struct VtpPiece {
  const XmlElement* points = nullptr;
  const XmlElement* pointNormals = nullptr;  ///< null where none are stored in a type that can hold them
  const XmlElement* cellNormals = nullptr;   ///< null likewise
  Index firstPoint = 0;                      ///< its first vertex in the mesh
  Index pointCount = 0;
  Index firstFace = 0;  ///< the face of its first polygon
  Index polygonCount = 0;
  Index firstPolygon = 0;  ///< the cell that is its first polygon, behind vertices and lines
};

/// Makes the source of a mesh that was read from the `pieces` of `file`. `notesOfMotion` are said where a vertex moves.
[[nodiscard]] std::shared_ptr<const MeshSource> makeVtpSource(VtpFile file, std::vector<VtpPiece> pieces,
                                                              std::vector<std::string> notesOfMotion);

}  // namespace holdfast
