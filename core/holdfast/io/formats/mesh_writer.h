#pragma once
/// \file
/// Mesh files made of positions and faces alone, with nothing to keep of a file that was read.

#include <holdfast/io/mesh_document.h>

namespace holdfast {

[[nodiscard]] Serialized writeObj(const Positions& positions, const Polygons& faces);
[[nodiscard]] Serialized writeOff(const Positions& positions, const Polygons& faces);

/// Binary little-endian, coordinates as doubles.
[[nodiscard]] Serialized writePly(const Positions& positions, const Polygons& faces);

/// Binary. Polygons are split into triangles that share their first corner. Throws `OutputError` where a coordinate
/// is too large for a float; notes say what was rounded and split.
[[nodiscard]] Serialized writeStl(const Positions& positions, const Polygons& faces);

}  // namespace holdfast
