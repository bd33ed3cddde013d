#pragma once
/// The smallest sphere around a mesh. Its diameter is a length that no rotation changes, unlike the diagonal of a box.

#include <holdfast/base/types.h>

namespace holdfast {

/// The diameter of the smallest sphere that holds all rows of `positions` (finite), in model units, to some 1e-12 of
/// itself; 0 where there are none. That of a box is its diagonal, however it stands. Some ten passes over the rows.
[[nodiscard]] double enclosingDiameter(const Positions& positions);

}  // namespace holdfast
