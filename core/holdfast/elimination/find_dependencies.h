#pragma once
/// These functions find the rows of B that depend on others. They do so during the decomposition, as in section 5 of
/// the paper.

#include <vector>

#include <holdfast/elimination/dependency.h>
#include <holdfast/elimination/sequential_qr.h>

namespace holdfast {

/// Returns every row that is a combination of rows before it, or too close to one to be told from it. Each comes with
/// the circuit that it closes; rows ascend. All other rows are independent. The result depends only on the rows and
/// their order, not on targets. Rows closer to the others than `tolerance` count as dependent.
///
/// Components of up to 512 rows and unknowns go through the sequential Householder QR of the paper. Larger ones go
/// through `sparseDependencies`. It finds the same rows, but for those that are closer than `kCrowdedDistance`. Small
/// components take this way too where a circuit shows that some rows are close.
///
/// With a larger tolerance than `kRankTolerance` all components take it. Then no row that is left is closer than
/// `tolerance` to the span of all others.
[[nodiscard]] std::vector<Dependency> findDependencies(const std::vector<RowTerms>& rows, Index unknownCount,
                                                       double tolerance = kRankTolerance);

/// Returns the rows that are not dependent, ascending.
[[nodiscard]] std::vector<Index> independentRows(const std::vector<Dependency>& dependencies, std::size_t rowCount);

/// Does what `findDependencies` does, for one component and by a dense QR.
[[nodiscard]] std::vector<Dependency> sequentialDependencies(const std::vector<RowTerms>& rows,
                                                             const RowComponent& component,
                                                             double tolerance = kRankTolerance);

}  // namespace holdfast
