#pragma once
/// Rotations and their logarithms, equations (22) to (24): those of unit quaternions, q = (angle / 2) times the unit
/// axis, in radians, not wrapped. All numbers are finite. Errors are a few units in the last place of the angle.

#include <numbers>

#include <Eigen/Geometry>

#include <holdfast/base/types.h>

namespace holdfast {

/// A degree in radians: degrees are for what people read and write.
inline constexpr double kDegree = std::numbers::pi / 180;

/// exp(q): the unit quaternion (cos |q|, sin |q| q / |q|).
[[nodiscard]] Eigen::Quaterniond rotationExp(const Vector3& q);

/// exp(q) as a matrix. A log that comes from quarter turns about a coordinate axis gives zeros and ones, as below.
[[nodiscard]] Eigen::Matrix3d rotationMatrix(const Vector3& q);

/// The rotation by `degrees` about `axis` (any length; none where it is zero), counterclockwise seen against it.
/// Quarter turns about coordinate axes have entries that are exactly 0, 1 and -1.
[[nodiscard]] Eigen::Matrix3d rotationMatrix(const Vector3& axis, double degrees);

/// How far exp(q) takes `x`, with the digits of that: R x - x.
[[nodiscard]] Vector3 shiftByRotation(const Vector3& q, const Vector3& x);

/// The shortest log of a rotation, |q| <= pi / 2, also of a quaternion of other length than 1. Of the two logs of a
/// half turn the one whose first component that is not zero is positive.
[[nodiscard]] Vector3 rotationLog(const Eigen::Quaterniond& rotation);
[[nodiscard]] Vector3 rotationLog(const Eigen::Matrix3d& rotation);

/// The log of a turn by `degrees` about `axis` (any length; no turn where it is zero).
[[nodiscard]] Vector3 rotationLog(const Vector3& axis, double degrees);

/// The log of `rotation` that is nearest to `reference`. A rotation by whole turns is taken to be about its axis.
[[nodiscard]] Vector3 rotationLogNear(const Eigen::Quaterniond& rotation, const Vector3& reference);

/// The angle of exp(q) in degrees, 0 or more, not wrapped.
[[nodiscard]] double angleDegrees(const Vector3& q);

}  // namespace holdfast
