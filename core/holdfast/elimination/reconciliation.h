#pragma once
/// Reconciliation meets redundant rows as well as the rows that they follow from.

#include <vector>

#include <holdfast/elimination/diagnosis.h>

namespace holdfast {

/// Returns `Elimination::particular` of `d` (rows x 3), changed so that the `redundant` rows are met as well. It solves
/// least squares over them and the rows that they follow from. Pins stay as they are. One sparse QR of the circuits is
/// made.
///
/// Where coefficients of circuits are large, rounding of d grows along a circuit, and `particular` misses redundant
/// rows by as much. This function misses none by more than the smallest change of d that makes all agree.
[[nodiscard]] Columns3 reconciledParticular(const EliminatedConstraints& eliminated,
                                            const std::vector<Index>& redundant, const Columns3& d);

}  // namespace holdfast
