#pragma once
/// \file
/// The surface of a box out of squares.

#include "grouped_mesh.h"

namespace holdfast::generate {

/// The closed surface of the box from `low` on with `cells` squares of side `step` along each axis, two triangles a
/// square, diagonals alternating, vertices shared, outward. Groups: x_low, x_high, y_low, y_high, z_low, z_high.
[[nodiscard]] GroupedMesh boxSurface(const Vector3& low, double step, const std::array<Index, 3>& cells);

}  // namespace holdfast::generate
