#pragma once
/// The mesh formats, in and out. `file` names the file in errors; every reader throws `InputError` with the line (text)
/// or the byte (binary), and keeps all that the file says besides the mesh.

#include <string>

#include <holdfast/io/mesh_document.h>

namespace holdfast {

/// Wavefront OBJ: polygons (`f`) make the mesh.
[[nodiscard]] MeshDocument readObj(std::string bytes, const std::string& file);

/// Object File Format (OFF, COFF, NOFF, CNOFF, STOFF and so on), one vertex or face a line.
[[nodiscard]] MeshDocument readOff(std::string bytes, const std::string& file);

/// PLY, text and binary of either byte order. The element `vertex` with x, y, z and the element `face` with the list
/// `vertex_indices` (or `vertex_index`) make the mesh. Where there are no faces, they are the triangles of the element
/// `tristrips`, whose lists are strips separated by -1: corners k, k + 1, k + 2 of a strip are a triangle, every second
/// one turned round, and no face where two of them are the same vertex.
[[nodiscard]] MeshDocument readPly(std::string bytes, const std::string& file);

/// STL, text and binary. Each facet has three vertices of its own, in file order. A file is binary if its size is what
/// the count in its binary header calls for, whatever the first bytes say.
[[nodiscard]] MeshDocument readStl(std::string bytes, const std::string& file);

/// Files made of positions and faces alone.
[[nodiscard]] Serialized writeObj(const Positions& positions, const Polygons& faces);
[[nodiscard]] Serialized writeOff(const Positions& positions, const Polygons& faces);

/// Binary little-endian, coordinates as doubles.
[[nodiscard]] Serialized writePly(const Positions& positions, const Polygons& faces);

/// Binary. Polygons are split into triangles that share their first corner; notes say what was rounded and split.
[[nodiscard]] Serialized writeStl(const Positions& positions, const Polygons& faces);

/// Adds a note on what floats lose of `positions`. Throws `OutputError` where a coordinate is too large for one.
void noteStlRounding(const Positions& positions, std::vector<std::string>& notes);

}  // namespace holdfast
