#pragma once
/// \file
/// Rows that repeat others and agree with them only as far as rounding goes, met together.

#include <vector>

#include <holdfast/elimination/diagnosis.h>

namespace holdfast {

/// As `Elimination::particular`, but `redundant` rows are met as well as the independent ones: by least squares over
/// both, in the span of the rows. Where coefficients of circuits are large, the displacement that meets the independent
/// rows to the last digit misses rows that follow from them by as much as rounding of d grows along the circuit; that
/// of least squares misses none by more than the smallest change of d that makes all agree. Pins stay copied bit for
/// bit. One sparse QR for each set of blocks that redundant rows join.
[[nodiscard]] Columns3 reconciledParticular(const EliminatedConstraints& eliminated,
                                            const std::vector<Index>& redundant, const Columns3& d);

}  // namespace holdfast
