#pragma once
/// Least-squares solutions with all the digits of a double out of a factor that has half of them.

#include <holdfast/solve/least_squares_factor.h>

namespace holdfast {

/// Factors that leave a larger share of an error are of no use: corrections do not converge, nor do they tell accuracy.
inline constexpr double kUsableContraction = 0.5;

struct CorrectedSolution {
  Columns3 z;            ///< k x 3
  Columns3 multipliers;  ///< kept x 3
  int corrections = 0;   ///< how many were needed
  double accuracy = 0;   ///< estimated relative error, from the sizes of the corrections
  double left = 0;       ///< share of an error that the factor leaves: the first correction; 0 where there was none
};

/// A solution that is there, where `z` is a small difference from it.
struct KnownSolution {
  double size = 0;       ///< largest absolute value of all of it
  Columns3 multipliers;  ///< its own, kept x 3; empty: zeros
  double left = 0;       ///< as in the `CorrectedSolution` of one with the same factor; 0 where that is not known
  double step = 0;       ///< how far the factor has just taken it there, largest absolute value; 0 where it has not

  /// Whether what is left of that step tells which share the factor leaves, and is not rounding of the whole.
  [[nodiscard]] bool isTelling() const noexcept { return step > 1e-3 * size; }
};

/// Corrected semi-normal equations (Björck, 1987): the residual is computed through C itself, never through C^T C, and
/// solved for once more with the same factor, until what a correction leaves is far below the accuracy that is reached,
/// or until corrections no longer shrink. `C` is what the factor was made of, its last `kept` rows hold exactly, `f` is
/// 0 there. Sizes are measured after `columnScale` (k), in the units that the user sees. Nothing is solved
/// where `f` is zero, and nothing corrected where `known` tells that a correction would change no digit of the whole.
[[nodiscard]] CorrectedSolution correctedSolve(const LeastSquaresFactor& factor, const LinearMap& C,
                                               const Eigen::VectorXd& columnScale, const Columns3& f, Index kept = 0,
                                               const KnownSolution& known = {});

/// How much of an error one correction leaves: 1e-8 for a good factor, 1 or more (or NaN) for a useless one. Measured
/// on `probe`, a known solution.
[[nodiscard]] double contraction(const LeastSquaresFactor& factor, const LinearMap& C, const Columns3& probe,
                                 Index kept = 0);

}  // namespace holdfast
