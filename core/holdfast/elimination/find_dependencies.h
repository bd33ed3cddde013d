#pragma once
/// Which rows of B depend on others, found during the decomposition as in section 5 of the paper.

#include <vector>

#include <holdfast/elimination/dependency.h>
#include <holdfast/elimination/sequential_qr.h>

namespace holdfast {

/// Every row that is a combination of rows before it, or too close to one to be told from it, with the circuit that it
/// closes; ascending. All other rows are independent. Depends on the rows and their order only, not on targets. Rows
/// closer to the others than `tolerance` count as dependent. Components of up to 512 rows and unknowns go through the
/// sequential Householder QR of the paper; larger ones through `sparseDependencies`, which finds the same rows but for
/// those that are closer than `kCrowdedDistance`: where a circuit shows that some are close, these ways judge small
/// components as well. With a larger tolerance than `kRankTolerance` all do: then no row that is left is closer than
/// that to the span of all others.
[[nodiscard]] std::vector<Dependency> findDependencies(const std::vector<RowTerms>& rows, Index unknownCount,
                                                       double tolerance = kRankTolerance);

/// The rows that are in no dependency, ascending.
[[nodiscard]] std::vector<Index> independentRows(const std::vector<Dependency>& dependencies, std::size_t rowCount);

/// `findDependencies` of one component, by a dense QR.
[[nodiscard]] std::vector<Dependency> sequentialDependencies(const std::vector<RowTerms>& rows,
                                                             const RowComponent& component,
                                                             double tolerance = kRankTolerance);

}  // namespace holdfast
