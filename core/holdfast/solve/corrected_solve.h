#pragma once
/// Corrected solves give least-squares solutions with all the digits of a double. The factor behind them has only half
/// of these.

#include <holdfast/solve/least_squares_factor.h>

namespace holdfast {

/// A factor that leaves a larger share of an error is of no use. Corrections do not converge with it, nor do they tell
/// the accuracy.
inline constexpr double kUsableContraction = 0.5;

struct CorrectedSolution {
  Columns3 z;            ///< k x 3
  Columns3 multipliers;  ///< kept x 3
  int corrections = 0;   ///< how many were needed
  double accuracy = 0;   ///< estimated relative error, from the sizes of the corrections
  double left = 0;       ///< share of an error that the factor leaves, by the first correction; 0 without one
};

/// A solution that is there already. `z` is then a small difference from it.
struct KnownSolution {
  double size = 0;       ///< largest absolute value of the whole
  Columns3 multipliers;  ///< its own, kept x 3; empty: zeros
  double left = 0;       ///< as in a `CorrectedSolution` with the same factor; 0 where that is not known
  double step = 0;       ///< largest absolute value of the factor's last step to it; 0 where there was none

  /// Tells whether what is left of that step shows the share that the factor leaves. Else it is rounding of the whole.
  [[nodiscard]] bool isTelling() const noexcept { return step > 1e-3 * size; }
};

/// Solves by corrected semi-normal equations (Björck, 1987). The residual is computed through C itself, never through
/// C^T C. The same factor solves for it once more. Corrections end when what one leaves is far below the accuracy that
/// is reached, or when they no longer shrink.
///
/// `C` is what the factor was made of. Its last `kept` rows hold exactly, and `f` is 0 there. Sizes are measured after
/// `columnScale` (k), in the units that the user sees. Where `f` is zero nothing is solved. Nothing is corrected where
/// `known` tells that a correction would change no digit of the whole.
[[nodiscard]] CorrectedSolution correctedSolve(const LeastSquaresFactor& factor, const LinearMap& C,
                                               const Eigen::VectorXd& columnScale, const Columns3& f, Index kept = 0,
                                               const KnownSolution& known = {});

/// Returns how much of an error one correction leaves: 1e-8 for a good factor, 1 or more (or NaN) for a useless one. It
/// is measured on `probe`, a known solution.
[[nodiscard]] double contraction(const LeastSquaresFactor& factor, const LinearMap& C, const Columns3& probe,
                                 Index kept = 0);

}  // namespace holdfast
