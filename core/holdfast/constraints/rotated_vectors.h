#pragma once
/// \file
/// Constraints that turn with the surface: right-hand sides once the rotations are known, for the vectors of rigid
/// regions, (28), and of Fig. 8.

#include <holdfast/constraints/constraint_system.h>

namespace holdfast {

/// `system` with the targets and shifts of its carried rows at the rotations `q` of all unknowns (n x 3, logs). Counts
/// from rest, whatever rotations the rows had before. Where q is 0 every row is as it was made, bit for bit. O(carried
/// rows), and a copy of the rest unless it is moved here.
[[nodiscard]] ConstraintSystem rotated(ConstraintSystem system, const Columns3& q);

}  // namespace holdfast
