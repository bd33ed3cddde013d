#pragma once
/// \file
/// A flat plate whose triangles are fine on one side and coarse on the other, without symmetry.

#include "grouped_mesh.h"

namespace holdfast::generate {

/// The square [0, 100] x [0, 100] at z = 0, with a border, facing up.
[[nodiscard]] GroupedMesh makePlate();

}  // namespace holdfast::generate
