#pragma once
/// A rotation fits two sets of points, or two directions. So a handle gets a rotation from its own frame.

#include <Eigen/Geometry>

#include <holdfast/numbers/types.h>

namespace holdfast {

struct RotationFit {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();  ///< proper: determinant +1
  bool isDetermined = false;                        ///< no other rotation fits as well
};

/// Squares of extents below this share of the largest count as zero. So points within a millionth of their length from
/// a line do not determine the rotation about it.
inline constexpr double kRankOfFit = 1e-12;

/// Returns the rotation R that minimises the sum of |R (p_i - mean of p) - (t_i - mean of t)|^2 over the rows of
/// `points` and `targets`. It is found by singular values (Kabsch, 1976). There must be as many points as targets, at
/// least one, and all must be finite. If points or targets lie on a line, R takes one line to the other by the shortest
/// rotation. If all coincide, R is the identity. O(N).
[[nodiscard]] RotationFit fitRotation(const Positions& points, const Positions& targets);

/// Returns the rotation R (of length 1) that minimises the sum of |R s - t|^2 for the covariance H = sum of t s^T.
/// Newton's method starts from `near`, of length 1. If several rotations fit, R is one that follows from `near`. If H
/// is zero, R is `near` itself. R is exact to a few units in the last place. If `near` fits without rounding, R has the
/// bits of `near`.
[[nodiscard]] Eigen::Quaterniond fittedRotation(const Eigen::Matrix3d& H, const Eigen::Quaterniond& near);

/// Returns the same among the rotations that follow from `near` by a turn about `axis`. The axis is of length 1 and in
/// space.
[[nodiscard]] Eigen::Quaterniond fittedRotationAbout(const Vector3& axis, const Eigen::Matrix3d& H,
                                                     const Eigen::Quaterniond& near);

struct DirectionTurn {
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();  ///< of length 1
  bool isDetermined = false;                                     ///< false where the directions are opposite
};

/// Returns the shortest rotation that takes the direction of `from` to that of `to`. Neither may be zero, and they may
/// have any lengths. Where they are opposite within rounding, the axis follows from `from` alone.
[[nodiscard]] DirectionTurn shortestRotation(const Vector3& from, const Vector3& to);

}  // namespace holdfast
