#pragma once
/// Householder QR of a dense matrix whose columns arrive one by one, in the user's order: section 5 of the paper.

#include <optional>
#include <vector>

#include <Eigen/Core>

#include <holdfast/base/types.h>

namespace holdfast {

/// A column counts as a combination of those before it when changing them and it by no more than this would make it
/// one, all scaled to length 1: |r| / |(1, a)|, with r = b - sum a_k b_k what is left of it. This bounds the least
/// singular value from above. Of two columns it is the distance at a sine of 1e-12. Columns of B^T hold barycentric
/// numbers only, so the decision depends on neither the size nor the units of the model. It is far below the distances
/// of constraints that engineers can tell apart (1e-9 of an edge).
inline constexpr double kRankTolerance = 7e-13;

/// The columns accepted so far as Q R. O(v r) per column, v rows and r accepted columns.
class SequentialQr {
 public:
  /// For columns of `rows` entries, at most `maxColumns` of which will be accepted.
  SequentialQr(Index rows, Index maxColumns);

  /// Accepts `column` and returns nothing when its distance from those accepted before exceeds `tolerance`; otherwise
  /// leaves all as it is and returns the coefficients that make it of the accepted columns, in their order. The column
  /// is not zero.
  [[nodiscard]] std::optional<Eigen::VectorXd> add(const Eigen::VectorXd& column, double tolerance = kRankTolerance);

  /// Accepts a column that is known to be independent, however close it is. False where nothing at all is left of it.
  [[nodiscard]] bool append(const Eigen::VectorXd& column);

  /// How far the last column that `add` was given is from being a combination of those accepted before.
  [[nodiscard]] double distance() const noexcept { return distance_; }

  [[nodiscard]] Index rank() const noexcept { return rank_; }

  /// rank x rank, upper triangular with B^T = Q [R; 0].
  [[nodiscard]] Eigen::MatrixXd R() const { return R_.topLeftCorner(rank_, rank_); }

  /// Q times `block` (v x any).
  [[nodiscard]] Eigen::MatrixXd applyQ(Eigen::MatrixXd block) const;

 private:
  [[nodiscard]] Eigen::VectorXd reflected(const Eigen::VectorXd& column) const;
  void accept(const Eigen::VectorXd& x, double left, double length);

  Index rank_ = 0;
  double distance_ = 0;
  Eigen::MatrixXd reflectors_;  // v x r, unit vectors h of I - 2 h h^T; entries above the k-th are zero
  Eigen::MatrixXd R_;
  Eigen::VectorXd lengths_;  // of the accepted columns
};

}  // namespace holdfast
