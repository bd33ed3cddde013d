#pragma once
/// A row of B that depends on others.

#include <vector>

#include <holdfast/elimination/row_components.h>

namespace holdfast {

/// Distances up to this are the rounding of numbers and of their elimination. The largest that was seen in 7,000
/// dependent columns of 162 entries was 5e-17. Between this and `kRankTolerance` doubles do not tell which it is.
inline constexpr double kRoundingDistance = 1e-15;

/// b_row = sum of coefficient * b_index over independent rows: a circuit, no smaller set of rows depends. Terms ascend.
/// Without terms the row is empty: it says 0 = d.
struct Dependency {
  Index row = 0;
  std::vector<Term> terms;
  /// By which it may be off that, see `kRankTolerance`; or how close to others it would have been, where another row
  /// stands in its place for that.
  double distance = 0;

  /// Whether doubles do not tell that the row depends on the others: it was left out for being close to them.
  [[nodiscard]] bool isUndecided() const noexcept { return distance > kRoundingDistance; }
};

/// Coefficients smaller than this are rounding of zero: as a share of the largest coefficient of the circuit where that
/// exceeds 1, as it does in circuits that lead from face to face. (Barycentric numbers of points that can be told apart
/// are larger.)
inline constexpr double kCoefficientThreshold = 1e-10;

/// The dependency of `row` by coefficients over `basis`, tiny ones left out.
[[nodiscard]] Dependency dependencyOf(Index row, const std::vector<Index>& basis, const Eigen::VectorXd& coefficients,
                                      double distance);

}  // namespace holdfast
