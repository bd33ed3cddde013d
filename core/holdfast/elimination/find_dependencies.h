#pragma once
/// Which rows of B depend on others, found during the decomposition as in section 5 of the paper.

#include <vector>

#include <holdfast/elimination/row_components.h>

namespace holdfast {

/// b_row = sum of coefficient * b_index over independent rows: a circuit, no smaller set of rows depends. Terms ascend.
/// Without terms the row is empty: it says 0 = d.
struct Dependency {
  Index row = 0;
  std::vector<Term> terms;
};

/// Coefficients smaller than this are rounding of zero: as a share of the largest coefficient of the circuit where that
/// exceeds 1, as it does in circuits that lead from face to face. (Barycentric numbers of points that can be told apart
/// are larger.)
inline constexpr double kCoefficientThreshold = 1e-10;

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
