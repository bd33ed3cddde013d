#pragma once
/// Which rows of B depend on others, found during the decomposition as in section 5 of the paper.

#include <vector>

#include <holdfast/elimination/dependency.h>
#include <holdfast/elimination/row_components.h>

namespace holdfast {

/// Every row that is a combination of rows before it, with the circuit that it closes; ascending. All other rows are
/// independent. Depends on the rows and their order only, not on targets. Small components go through the sequential
/// Householder QR of the paper; large ones through sparse QR in a fill-reducing order, and then exchanges to the user's
/// order; both find the same rows. A row whose sine to the span of the others is below
/// `kRankTolerance` counts as dependent.
[[nodiscard]] std::vector<Dependency> findDependencies(const std::vector<RowTerms>& rows, Index unknownCount);

/// The rows that are in no dependency, ascending.
[[nodiscard]] std::vector<Index> independentRows(const std::vector<Dependency>& dependencies, std::size_t rowCount);

/// `findDependencies` of one component, by either way.
[[nodiscard]] std::vector<Dependency> sequentialDependencies(const std::vector<RowTerms>& rows,
                                                             const RowComponent& component);
[[nodiscard]] std::vector<Dependency> sparseDependencies(const std::vector<RowTerms>& rows,
                                                         const RowComponent& component);

}  // namespace holdfast
