#pragma once
/// \file
/// Shapes as functions of place: negative inside, zero on the surface, about the distance nearby.

#include <algorithm>
#include <cmath>
#include <functional>

#include <holdfast/base/types.h>

namespace holdfast::generate {

using DistanceFunction = std::function<double(const Vector3&)>;

inline double sphere(const Vector3& place, const Vector3& centre, double radius)
{
  return (place - centre).norm() - radius;
}

/// To first order: exact on the surface and in its slope there. The centre must not be asked for.
inline double ellipsoid(const Vector3& place, const Vector3& centre, const Vector3& radii)
{
  const Vector3 scaled = (place - centre).cwiseQuotient(radii);
  const double length = scaled.norm();
  return length * (length - 1) / scaled.cwiseQuotient(radii).norm();
}

/// A segment with round ends whose radius goes evenly from `radiusA` to `radiusB`.
inline double taperedCapsule(const Vector3& place, const Vector3& a, const Vector3& b, double radiusA, double radiusB)
{
  const Vector3 along = b - a;
  const double t = std::clamp((place - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (place - a - t * along).norm() - ((1 - t) * radiusA + t * radiusB);
}

inline double capsule(const Vector3& place, const Vector3& a, const Vector3& b, double radius)
{
  return taperedCapsule(place, a, b, radius, radius);
}

/// The union, with a fillet where both are closer than `blend` to one another.
inline double blended(double a, double b, double blend)
{
  const double overlap = std::max(blend - std::abs(a - b), 0.0) / blend;
  return std::min(a, b) - overlap * overlap * blend / 4;
}

/// `a` without `b`, with a rounded rim.
inline double carved(double a, double b, double blend)
{
  return -blended(-a, b, blend);
}

/// Central differences, over a length far below any detail of a shape and far above rounding.
inline Vector3 gradient(const DistanceFunction& distance, const Vector3& place)
{
  constexpr double kStep = 1e-4;
  Vector3 result;
  for (Index axis = 0; axis < 3; ++axis) {
    const Vector3 step = kStep * Vector3::Unit(axis);
    result[axis] = (distance(place + step) - distance(place - step)) / (2 * kStep);
  }
  return result;
}

/// The surface point that Newton's method reaches from a `place` nearby.
inline Vector3 projected(const DistanceFunction& distance, Vector3 place)
{
  constexpr int kSteps = 2;
  for (int step = 0; step < kSteps; ++step) {
    const Vector3 slope = gradient(distance, place);
    place -= distance(place) * slope / slope.squaredNorm();
  }
  return place;
}

}  // namespace holdfast::generate
