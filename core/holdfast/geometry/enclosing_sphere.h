#pragma once
/// The smallest sphere around a mesh. Its diameter is a length that no rotation changes, unlike the diagonal of a box.

#include <holdfast/numbers/types.h>

namespace holdfast {

/// Returns the diameter of the smallest sphere that holds all rows of `positions` (finite), in model units. It is exact
/// to some 1e-12 of itself, and 0 where there are no rows. The diameter of a box is its diagonal, however it stands.
/// This takes some ten passes over the rows.
[[nodiscard]] double enclosingDiameter(const Positions& positions);

}  // namespace holdfast
