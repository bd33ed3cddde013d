#pragma once
/// Householder QR of a dense matrix whose columns arrive one by one, in the user's order: section 5 of the paper.

#include <optional>

#include <Eigen/Core>

#include <holdfast/base/types.h>

namespace holdfast {

/// A column counts as a combination of those before it when what is left of it after their elimination is this share of
/// its length or less: the sine of its angle to their span. Columns of B^T hold barycentric numbers only, so the
/// decision depends on neither the size nor the units of the model. It is far above the rounding of a block's
/// elimination (about 1e-15) and far below the angles of constraints that engineers can tell apart (1e-9 of an edge).
inline constexpr double kRankTolerance = 1e-12;

/// The columns accepted so far as Q R. O(v r) per column, v rows and r accepted columns.
class SequentialQr {
 public:
  /// For columns of `rows` entries, at most `maxColumns` of which will be accepted.
  SequentialQr(Index rows, Index maxColumns);

  /// Accepts `column` and returns nothing when it is independent of those accepted before; otherwise leaves all as it
  /// is and returns the coefficients that make it of the accepted columns, in their order. The column is not zero.
  [[nodiscard]] std::optional<Eigen::VectorXd> add(const Eigen::VectorXd& column);

  [[nodiscard]] Index rank() const noexcept { return rank_; }

  /// rank x rank, upper triangular with B^T = Q [R; 0].
  [[nodiscard]] Eigen::MatrixXd R() const { return R_.topLeftCorner(rank_, rank_); }

  /// Q times `block` (v x any).
  [[nodiscard]] Eigen::MatrixXd applyQ(Eigen::MatrixXd block) const;

 private:
  Index rank_ = 0;
  Eigen::MatrixXd reflectors_;  // v x r, unit vectors h of I - 2 h h^T; entries above the k-th are zero
  Eigen::MatrixXd R_;
};

}  // namespace holdfast
