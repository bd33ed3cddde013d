#pragma once
/// \file
/// Rows with directions as equations of all three coordinates at once, solved densely.

#include <optional>

#include <holdfast/constraints/constraint_system.h>

namespace holdfast::test {

/// Returns u (n x 3) that minimises |A u - f| under the rows of `system`, by LAPACK over 3n unknowns. `A` is n x n, `f`
/// n x 3. Nothing in a build without LAPACK. The rows must be independent.
[[nodiscard]] std::optional<Columns3> wholeSolution(const Eigen::MatrixXd& A, const Columns3& f,
                                                    const ConstraintSystem& system);

}  // namespace holdfast::test
