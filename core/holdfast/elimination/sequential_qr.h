#pragma once
/// Householder QR of a dense matrix whose columns arrive one by one, in the user's order: section 5 of the paper.

#include <optional>

#include <Eigen/Core>

#include <holdfast/numbers/types.h>

namespace holdfast {

/// A column counts as a combination of those before it when a change of at most this would make it one. The change is
/// to the column and to those before it, all scaled to length 1. The distance is |r| / |(1, a)|, where r = b - sum a_k
/// b_k is what is left of the column. It bounds the least singular value from above. For two columns this tolerance is
/// the distance at a sine of 1e-12.
///
/// Columns of B^T hold barycentric numbers only. So the decision depends on neither the size nor the units of the
/// model. The tolerance is far below the distances of constraints that engineers can tell apart (1e-9 of an edge).
inline constexpr double kRankTolerance = 7e-13;

/// A QR of the columns accepted so far. Each column costs O(v r), with v rows and r accepted columns.
class SequentialQr {
 public:
  /// Takes columns of `rows` entries. At most `maxColumns` of them will be accepted.
  SequentialQr(Index rows, Index maxColumns);

  /// Accepts `column` and returns nothing when its distance from those accepted before exceeds `tolerance`. Otherwise
  /// it changes nothing. It then returns the coefficients that make the column of the accepted ones, in their order.
  /// The column must not be zero.
  [[nodiscard]] std::optional<Eigen::VectorXd> add(const Eigen::VectorXd& column, double tolerance = kRankTolerance);

  /// Accepts a column that is known to be independent, however close it is. Returns false where nothing at all is left
  /// of it.
  [[nodiscard]] bool append(const Eigen::VectorXd& column);

  /// Returns how far the last column given to `add` is from a combination of those accepted before.
  [[nodiscard]] double distance() const noexcept { return distance_; }

  [[nodiscard]] Index rank() const noexcept { return rank_; }

  /// Returns R, rank x rank and upper triangular, with B^T = Q [R; 0].
  [[nodiscard]] Eigen::MatrixXd R() const { return R_.topLeftCorner(rank_, rank_); }

  /// Returns Q times `block` (v x any).
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
