#pragma once
/// Redundant rows that are met as well as those that they follow from.

#include <vector>

#include <holdfast/elimination/diagnosis.h>

namespace holdfast {

/// `Elimination::particular` of `d` (rows x 3) with the `redundant` rows met as well, by least squares over them and
/// the rows that they follow from; pins stay as they are. Where coefficients of circuits are large, `particular` misses
/// redundant rows by as much as rounding of d grows along the circuit; this misses none by more than the smallest
/// change of d that makes all agree. One sparse QR of the circuits.
[[nodiscard]] Columns3 reconciledParticular(const EliminatedConstraints& eliminated,
                                            const std::vector<Index>& redundant, const Columns3& d);

}  // namespace holdfast
