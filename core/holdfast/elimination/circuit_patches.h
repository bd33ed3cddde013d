#pragma once
/// Circuits of many rows, most of which stay near their row.

#include <vector>

#include <holdfast/elimination/dependency.h>

namespace holdfast {

/// `circuitsOf`, where `others` are many by one sparse QR of each patch of rows that they lie in the middle of, and by
/// one of all rows for those whose circuits leave their patches. `unknowns` ascend. The time is that of `circuitsOf`
/// for the latter and, for the former, proportional to their number.
[[nodiscard]] std::vector<Dependency> circuitsByPatches(const std::vector<RowTerms>& rows,
                                                        const std::vector<Index>& basis,
                                                        const std::vector<Index>& others,
                                                        const std::vector<Index>& unknowns);

}  // namespace holdfast
