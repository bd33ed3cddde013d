#pragma once
/// A bound keeps the offset of a point within a ball or on one side of a plane.

#include <holdfast/constraints/row_directions.h>
#include <holdfast/numbers/types.h>

namespace holdfast {

/// Returns the matrix M with M r = directions.held(r).
[[nodiscard]] Eigen::Matrix3d matrixOf(const RowDirections& directions);

/// Returns `r` with `held` in place of the part of it that the directions hold.
[[nodiscard]] Vector3 withHeld(const RowDirections& directions, const Vector3& r, const Vector3& held);

/// Returns a number with room to both bounds, 0 where it has. `low` is less than `high`, and one of them may be
/// infinite.
[[nodiscard]] double withinBounds(double low, double high);

/// Returns the size of the room between these bounds. Bounds to one side have one as well.
[[nodiscard]] double roomBetween(double low, double high);

/// A bound says g(r) <= 0 of the offset r of a point. For a ball g is (|r / size|^2 - 1) / 2, with the part of r that
/// its directions hold. For half a space it is (normal . r - most) / size.
struct OffsetBound {
  Index point = 0;
  bool isBall = false;
  double size = 1;
  Vector3 normal = Vector3::Zero();
  double most = 0;
  RowDirections directions = {};  ///< of a ball

  /// These are g and its derivatives. That of second order is the same everywhere.
  [[nodiscard]] double value(const Vector3& r) const;
  [[nodiscard]] Vector3 gradient(const Vector3& r) const;
  [[nodiscard]] Eigen::Matrix3d curvature() const;

  /// An energy that pulls r well within the bound: its second derivative, and its first one at `r`.
  [[nodiscard]] Eigen::Matrix3d curvatureOfPull() const;
  [[nodiscard]] Vector3 gradientOfPull(const Vector3& r) const;

  /// Returns the nearest offset at the bound.
  [[nodiscard]] Vector3 onto(const Vector3& r) const;

  /// Returns the longest step along `step` that does not leave the bound. r lies within it.
  [[nodiscard]] double longest(const Vector3& r, const Vector3& step) const;
};

}  // namespace holdfast
