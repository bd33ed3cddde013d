#pragma once
/// The rotation that fits two sets of points, or two directions: how a handle gets a rotation from its own frame.

#include <Eigen/Geometry>

#include <holdfast/base/types.h>

namespace holdfast {

struct RotationFit {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();  ///< proper: determinant +1
  bool isDetermined = false;                        ///< no other rotation fits as well
};

/// Squares of extents below this share of the largest count as zero: points within a millionth of their length from a
/// line do not determine the rotation about it.
inline constexpr double kRankOfFit = 1e-12;

/// The rotation R that minimises the sum of |R (p_i - mean of p) - (t_i - mean of t)|^2 over the rows of `points` and
/// `targets`: as many of each, finite, at least one (Kabsch, 1976; by singular values). Where points or targets lie on
/// a line, R takes one line to the other by the shortest rotation; where all coincide, it is the identity. O(N).
[[nodiscard]] RotationFit fitRotation(const Positions& points, const Positions& targets);

/// The rotation R (of length 1) that minimises the sum of |R s - t|^2 for the covariance H = sum of t s^T, by Newton's
/// method from `near`, of length 1. Where several fit, one that follows from `near`, which it is itself where H says
/// nothing. Exact to a few units in the last place; `near` as it is, bit for bit, where it fits without rounding.
[[nodiscard]] Eigen::Quaterniond fittedRotation(const Eigen::Matrix3d& H, const Eigen::Quaterniond& near);

/// The same among the rotations that follow from `near` by a turn about `axis`, of length 1 and in space.
[[nodiscard]] Eigen::Quaterniond fittedRotationAbout(const Vector3& axis, const Eigen::Matrix3d& H,
                                                     const Eigen::Quaterniond& near);

struct DirectionTurn {
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();  ///< of length 1
  bool isDetermined = false;                                     ///< false where the directions are opposite
};

/// The shortest rotation that takes the direction of `from` to that of `to` (neither zero, any lengths), about an axis
/// that follows from `from` alone where they are opposite within rounding.
[[nodiscard]] DirectionTurn shortestRotation(const Vector3& from, const Vector3& to);

}  // namespace holdfast
