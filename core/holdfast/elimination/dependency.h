#pragma once
/// A row of B that depends on others.

#include <vector>

#include <holdfast/elimination/row_components.h>

namespace holdfast {

/// Distances up to this are rounding, of numbers and of their elimination. The largest that was seen in 7,000 dependent
/// columns of 162 entries was 5e-17. Between this and `kRankTolerance` doubles do not tell whether a row depends on
/// others.
inline constexpr double kRoundingDistance = 1e-15;

/// A dependency states b_row = sum of coefficient * b_index over independent rows. It is a circuit: no smaller set of
/// these rows depends. Terms ascend. A dependency without terms belongs to an empty row, which says 0 = d.
struct Dependency {
  Index row = 0;
  std::vector<Term> terms;
  /// The row may be off that sum by this much, see `kRankTolerance`. The row may also have been too close to others, so
  /// that another row stands in its place. Then this is how close it would have been.
  double distance = 0;

  /// Tells whether doubles leave it open that the row depends on the others. The row was left out because it is close
  /// to them.
  [[nodiscard]] bool isUndecided() const noexcept { return distance > kRoundingDistance; }
};

/// Coefficients smaller than this are rounding of zero. Where the largest coefficient of the circuit exceeds 1, this is
/// a share of it. That happens in circuits that lead from face to face. The barycentric numbers of points that can be
/// told apart are larger.
inline constexpr double kCoefficientThreshold = 1e-10;

/// Makes the dependency of `row` from coefficients over `basis`. It leaves tiny coefficients out.
[[nodiscard]] Dependency dependencyOf(Index row, const std::vector<Index>& basis, const Eigen::VectorXd& coefficients,
                                      double distance);

}  // namespace holdfast
