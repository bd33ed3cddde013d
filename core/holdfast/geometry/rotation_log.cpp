#include "holdfast/geometry/rotation_log.h"

#include <array>
#include <cmath>
#include <limits>

namespace holdfast {
namespace {

using std::numbers::pi;

// The axis of a rotation within rounding of whole turns is noise.
constexpr double kWholeTurns = 8 * std::numeric_limits<double>::epsilon();

/// The length, also where its square is no double.
double length(const Vector3& v)
{
  const double square = v.squaredNorm();
  const bool isNormal = square > 1e-280 && square < 1e280;
  return isNormal ? std::sqrt(square) : std::hypot(v.x(), v.y(), v.z());
}

struct CosineAndSine {
  double cosine;
  double sine;
};

/// Whole quarters are taken off before radians, which cannot name them, come into it.
CosineAndSine cosineAndSine(double degrees)
{
  int quarters = 0;
  const double radians = std::remquo(degrees, 90.0, &quarters) * (pi / 180);
  const double c = std::cos(radians);
  const double s = std::sin(radians);
  return std::array<CosineAndSine, 4>{{{c, s}, {-s, c}, {-c, -s}, {s, -c}}}[quarters & 3];
}

/// Tells whether q, not -q, is taken as the log of the half turn that has both.
bool isFirstOfHalfTurn(const Vector3& q)
{
  for (const double component : q)
    if (component != 0) return component > 0;
  return true;
}

}  // namespace

Eigen::Quaterniond rotationExp(const Vector3& q)
{
  const double half = length(q);
  const Vector3 v = half == 0 ? q : Vector3(q * (std::sin(half) / half));
  return {std::cos(half), v.x(), v.y(), v.z()};
}

Eigen::Matrix3d rotationMatrix(const Vector3& q)
{
  return rotationMatrix(q, angleDegrees(q));
}

Eigen::Matrix3d rotationMatrix(const Vector3& axis, double degrees)
{
  const double size = length(axis);
  if (size == 0) return Eigen::Matrix3d::Identity();
  const Vector3 a = axis / size;
  const auto [c, s] = cosineAndSine(degrees);
  Eigen::Matrix3d cross;
  cross << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  return c * Eigen::Matrix3d::Identity() + s * cross + (1 - c) * a * a.transpose();
}

Vector3 shiftByRotation(const Vector3& q, const Vector3& x)
{
  const double size = length(q);
  if (size == 0) return Vector3::Zero();
  const Vector3 a = q / size;
  const auto [c, s] = cosineAndSine(size / pi * 360);
  const Vector3 across = a.cross(x);
  const double versine = c > 0 ? s * s / (1 + c) : 1 - c;  // no digits cancel
  return s * across + versine * a.cross(across);
}

Vector3 rotationLog(const Eigen::Quaterniond& rotation)
{
  const Vector3 v = rotation.vec();
  const double sine = length(v);
  if (sine == 0) return Vector3::Zero();
  const Vector3 q = v * (std::atan2(sine, std::abs(rotation.w())) / sine);
  const bool isAsGiven = rotation.w() == 0 ? isFirstOfHalfTurn(q) : rotation.w() > 0;
  return isAsGiven ? q : Vector3(-q);
}

Vector3 rotationLog(const Eigen::Matrix3d& rotation)
{
  return rotationLog(Eigen::Quaterniond(rotation));
}

Vector3 rotationLog(const Vector3& axis, double degrees)
{
  const double size = length(axis);
  return size == 0 ? Vector3(Vector3::Zero()) : Vector3(axis / size * (degrees / 360 * pi));
}

Vector3 rotationLogNear(const Eigen::Quaterniond& rotation, const Vector3& reference)
{
  const Vector3 shortest = rotationLog(rotation);
  const double half = length(shortest);
  const double far = length(reference);
  if (half > kWholeTurns) {
    const Vector3 axis = shortest / half;
    return axis * (half + pi * std::round((axis.dot(reference) - half) / pi));
  }
  const double turns = std::round(far / pi);
  return turns == 0 ? shortest : Vector3(reference / far * (pi * turns));
}

double angleDegrees(const Vector3& q)
{
  return length(q) / pi * 360;
}

}  // namespace holdfast
