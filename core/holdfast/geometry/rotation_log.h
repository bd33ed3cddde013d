#pragma once
/// Rotations have logarithms, equations (22) to (24). They are those of unit quaternions: q = (angle / 2) times the
/// unit axis, in radians, not wrapped. All numbers are finite. Errors are a few units in the last place of the angle.

#include <numbers>

#include <Eigen/Geometry>

#include <holdfast/numbers/types.h>

namespace holdfast {

/// This is a degree in radians. Degrees are for what people read and write.
inline constexpr double kDegree = std::numbers::pi / 180;

/// Returns exp(q): the unit quaternion (cos |q|, sin |q| q / |q|).
[[nodiscard]] Eigen::Quaterniond rotationExp(const Vector3& q);

/// Returns exp(q) as a matrix. A log that comes from quarter turns about a coordinate axis gives zeros and ones, as
/// below.
[[nodiscard]] Eigen::Matrix3d rotationMatrix(const Vector3& q);

/// Returns the rotation by `degrees` about `axis`, counterclockwise seen against it. The axis may have any length. If
/// it is zero, the result is the identity. Quarter turns about coordinate axes have entries 0, 1 and -1, exactly.
[[nodiscard]] Eigen::Matrix3d rotationMatrix(const Vector3& axis, double degrees);

/// Returns how far exp(q) takes `x`, with the digits of that: R x - x.
[[nodiscard]] Vector3 shiftByRotation(const Vector3& q, const Vector3& x);

/// Returns the shortest log of a rotation, |q| <= pi / 2. A quaternion may be of another length than 1. Of the two logs
/// of a half turn it is the one whose first component that is not zero is positive.
[[nodiscard]] Vector3 rotationLog(const Eigen::Quaterniond& rotation);
[[nodiscard]] Vector3 rotationLog(const Eigen::Matrix3d& rotation);

/// Returns the log of a turn by `degrees` about `axis`. The axis may have any length. If it is zero, the log is zero.
[[nodiscard]] Vector3 rotationLog(const Vector3& axis, double degrees);

/// Returns the log of `rotation` that is nearest to `reference`. A rotation by whole turns is taken to be about the
/// axis of `reference`.
[[nodiscard]] Vector3 rotationLogNear(const Eigen::Quaterniond& rotation, const Vector3& reference);

/// Returns the angle of exp(q) in degrees, 0 or more, not wrapped.
[[nodiscard]] double angleDegrees(const Vector3& q);

}  // namespace holdfast
