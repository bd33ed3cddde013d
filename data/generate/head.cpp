#include "head.h"

#include <array>

#include "contour.h"
#include "remesh.h"

namespace holdfast::generate {
namespace {

constexpr double kNeckEnd = -112;

// The right half stands for both.
Vector3 folded(const Vector3& place)
{
  return {std::abs(place.x()), place.y(), place.z()};
}

double skull(const Vector3& p)
{
  double result = ellipsoid(p, {0, 6, 42}, {70, 80, 74});
  result = blended(result, ellipsoid(p, {0, -14, -22}, {50, 54, 54}), 30);
  result = blended(result, sphere(p, {36, -40, -10}, 24), 20);
  result = blended(result, sphere(p, {0, -51, -60}, 18), 18);
  return blended(result, capsule(p, {0, 22, -40}, {0, 26, -140}, 37), 24);
}

double eyes(const Vector3& p, double face)
{
  double result = carved(face, sphere(p, {28, -84, 25}, 19), 16);
  const double brow = blended(taperedCapsule(p, {13, -74, 50}, {33, -68, 58}, 5, 8),
                              taperedCapsule(p, {33, -68, 58}, {55, -48, 50}, 8, 3), 8);
  result = blended(result, brow, 14);
  const double ball = sphere(p, {28, -58, 25}, 20);
  const double pupil = sphere(p, {26, -80, 24}, 7);
  return blended(result, carved(ball, pupil, 4), 6);
}

double nose(const Vector3& p, double face)
{
  const double result = blended(face, taperedCapsule(p, {0, -70, 30}, {0, -90, 0}, 7, 14), 14);
  return blended(result, sphere(p, {12, -80, -4}, 8), 8);
}

double ears(const Vector3& p, double face)
{
  const double result = blended(face, ellipsoid(p, {78, 10, 22}, {13, 23, 31}), 14);
  return carved(result, ellipsoid(p, {91, 2, 24}, {11, 13, 19}), 9);
}

// A curve on the skull, from the middle to the corner of a smile.
constexpr Index kMouthSteps = 8;
using MouthCurve = std::array<Vector3, kMouthSteps + 1>;

// Where the skull's surface is on the line along y.
Vector3 onFace(double x, double z)
{
  double outside = -200, inside = -20;
  for (int step = 0; step < 60; ++step) {
    const double middle = (outside + inside) / 2;
    (skull({x, middle, z}) > 0 ? outside : inside) = middle;
  }
  return {x, inside, z};
}

MouthCurve mouthCurve(double height, double width, double bend)
{
  MouthCurve result;
  for (Index i = 0; i <= kMouthSteps; ++i) {
    const double x = width * static_cast<double>(i) / kMouthSteps;
    result[i] = onFace(x, height + bend * x * x);
  }
  return result;
}

double tube(const Vector3& p, const MouthCurve& curve, double radius, double endRadius)
{
  double result = std::numeric_limits<double>::infinity();
  for (Index i = 0; i < kMouthSteps; ++i) {
    const double from = radius + (endRadius - radius) * static_cast<double>(i) / kMouthSteps;
    const double to = radius + (endRadius - radius) * static_cast<double>(i + 1) / kMouthSteps;
    result = std::min(result, taperedCapsule(p, curve[i], curve[i + 1], from, to));
  }
  return result;
}

double mouth(const Vector3& p, double face)
{
  // Far from the mouth the lips do not reach; saves most of the time.
  if (sphere(p, {0, -66, -36}, 45) > 20) return face;
  static const MouthCurve upper = mouthCurve(-30, 26, 0.010), groove = mouthCurve(-39, 36, 0.012),
                          lower = mouthCurve(-48, 24, 0.016);
  double result = blended(face, tube(p, upper, 5, 2.5), 12);
  result = blended(result, tube(p, lower, 6.5, 2.5), 12);
  return carved(result, tube(p, groove, 4.2, 3.6), 5);
}

double headDistance(const Vector3& place)
{
  const Vector3 p = folded(place);
  const double head = ears(p, mouth(p, nose(p, eyes(p, skull(p)))));
  return -blended(-head, place.z() - kNeckEnd, 12);
}

// Fine near what a face is recognised by, coarser away from it.
double edgeLength(const Vector3& place)
{
  constexpr double kFinest = 2.1, kCoarsest = 4.6, kGrowth = 0.055;
  const Vector3 p = folded(place);
  const double away = std::min({sphere(p, {27, -66, 26}, 20), sphere(p, {0, -84, 0}, 16), sphere(p, {80, 10, 24}, 26),
                                ellipsoid(p, {0, -66, -35}, {36, 30, 16})});
  return std::clamp(kFinest + kGrowth * away, kFinest, kCoarsest);
}

}  // namespace

GroupedMesh makeHead()
{
  constexpr double kGridStep = 3;
  const Eigen::AlignedBox3d box(Vector3(-101, -121, -131), Vector3(101, 111, 131));
  return remeshed(contour(headDistance, box, kGridStep), headDistance, edgeLength);
}

}  // namespace holdfast::generate
