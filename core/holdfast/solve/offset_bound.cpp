#include "holdfast/solve/offset_bound.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace holdfast {

Eigen::Matrix3d matrixOf(const RowDirections& directions)
{
  Eigen::Matrix3d M;
  for (Index k = 0; k < 3; ++k) M.col(k) = directions.held(Vector3::Unit(k));
  return M;
}

Vector3 withHeld(const RowDirections& directions, const Vector3& r, const Vector3& held)
{
  return r + (held - directions.held(r));
}

double roomBetween(double low, double high)
{
  // Of bounds in diagonals of a mesh.
  constexpr double kLeast = 1e-3;
  const double width = high - low;
  return std::isfinite(width) ? width : std::max(kLeast, std::abs(std::isfinite(low) ? low : high));
}

double withinBounds(double low, double high)
{
  if (low < 0 && high > 0) return 0;
  if (std::isinf(low)) return high - roomBetween(low, high);
  if (std::isinf(high)) return low + roomBetween(low, high);
  return (low + high) / 2;
}

double OffsetBound::value(const Vector3& r) const
{
  return isBall ? ((directions.held(r) / size).squaredNorm() - 1) / 2 : (normal.dot(r) - most) / size;
}

Vector3 OffsetBound::gradient(const Vector3& r) const
{
  return isBall ? Vector3(directions.held(r) / size / size) : Vector3(normal / size);
}

Eigen::Matrix3d OffsetBound::curvature() const
{
  if (!isBall) return Eigen::Matrix3d::Zero();
  return matrixOf(directions) / size / size;
}

Eigen::Matrix3d OffsetBound::curvatureOfPull() const
{
  return isBall ? curvature() : Eigen::Matrix3d(gradient(normal) * gradient(normal).transpose());
}

/// (g + 1)^2 / 2 of half a space, whose g has no end.
Vector3 OffsetBound::gradientOfPull(const Vector3& r) const
{
  return isBall ? gradient(r) : Vector3((value(r) + 1) * gradient(r));
}

Vector3 OffsetBound::onto(const Vector3& r) const
{
  if (!isBall) return r + (most - normal.dot(r)) * normal;
  const Vector3 held = directions.held(r);
  return withHeld(directions, r, held * (size / held.norm()));
}

double OffsetBound::longest(const Vector3& r, const Vector3& step) const
{
  constexpr double kNever = std::numeric_limits<double>::infinity();
  if (!isBall) {
    const double along = normal.dot(step);
    return along > 0 ? (most - normal.dot(r)) / along : kNever;
  }
  const Vector3 held = directions.held(r);
  const Vector3 heldStep = directions.held(step);
  const double a = heldStep.squaredNorm();
  if (a == 0) return kNever;
  const double b = held.dot(heldStep);
  const double c = held.squaredNorm() - size * size;  // below 0
  const double root = std::sqrt(b * b - a * c);
  return b > 0 ? -c / (b + root) : (root - b) / a;
}

}  // namespace holdfast
