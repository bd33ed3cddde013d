#pragma once
/// \file
/// A head on its neck, in millimetres: x to its left, y from face to back, z up. Symmetric as a shape, not as a mesh.

#include "grouped_mesh.h"

namespace holdfast::generate {

/// Closed, smooth, one part, outward; no groups. Triangles are small around eyes, nose, mouth and ears.
[[nodiscard]] GroupedMesh makeHead();

}  // namespace holdfast::generate
