#pragma once
/// Circuits of many rows, most of which stay near their row.

#include <vector>

#include <holdfast/elimination/dependency.h>

namespace holdfast {

/// A basis is thinned where rows were taken out of it because they were close to the others. A row that needs these
/// does not depend on the rest.
enum class BasisKind { Whole, Thinned };

/// Returns what `circuitsOf` returns, by patches where `others` are many. One sparse QR of each patch finds the
/// circuits of the rows in its middle. One sparse QR of all rows finds the circuits that leave their patches.
/// `unknowns` ascend. The patches take time proportional to the number of their rows; the rest takes the time of
/// `circuitsOf`. A row may not depend on a thinned basis. It then gets the combination of its patch that is nearest to
/// it, with its distance.
[[nodiscard]] std::vector<Dependency> circuitsByPatches(const std::vector<RowTerms>& rows,
                                                        const std::vector<Index>& basis,
                                                        const std::vector<Index>& others,
                                                        const std::vector<Index>& unknowns, BasisKind kind);

}  // namespace holdfast
