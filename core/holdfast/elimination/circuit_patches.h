#pragma once
/// Circuits of many rows, most of which stay near their row.

#include <vector>

#include <holdfast/elimination/dependency.h>

namespace holdfast {

/// `Thinned`: rows were taken out for being close to the others. What needs them does not depend on the rest.
enum class BasisKind { Whole, Thinned };

/// `circuitsOf`, where `others` are many by one sparse QR of each patch of rows that they lie in the middle of, and by
/// one of all rows for those whose circuits leave their patches. `unknowns` ascend. The time is that of `circuitsOf`
/// for the latter and, for the former, proportional to their number. A row that does not depend on a thinned basis gets
/// the combination of its patch that is nearest to it, with its distance.
[[nodiscard]] std::vector<Dependency> circuitsByPatches(const std::vector<RowTerms>& rows,
                                                        const std::vector<Index>& basis,
                                                        const std::vector<Index>& others,
                                                        const std::vector<Index>& unknowns, BasisKind kind);

}  // namespace holdfast
