#pragma once
/// These functions make the positions that a file gets from displacements of unknowns.

#include <holdfast/deform/model.h>
#include <holdfast/elimination/diagnosis.h>

namespace holdfast {

/// The file's positions: pins as `system` asks for them, bit for bit, everything else displaced by `u` (n x 3) from
/// rest. Coordinates that a row holds by themselves are copied as well. Pins that
/// `diagnosis` leaves out are displaced. What does not move keeps its bits, -0 included. O(n).
[[nodiscard]] Positions deformedPositions(const Model& model, const ConstraintSystem& system,
                                          const Diagnosis& diagnosis, const Columns3& u);

}  // namespace holdfast
