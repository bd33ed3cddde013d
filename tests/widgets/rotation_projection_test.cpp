#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <holdfast/geometry/rotation_log.h>
#include <holdfast/widgets/rotation_sphere/rotation_projection.h>

#include "support/meshes.h"

namespace holdfast {
namespace {

constexpr double kRounding = 1e-14;

/// A frame that hides `axis`.
SphereFrame hiding(const Vector3& axis)
{
  const Vector3 a = axis.unitOrthogonal();
  return sphereFrame({{a, ""}, {axis.cross(a), ""}}, {});
}

TEST(RotationProjection, TheIdentityIsThePole)
{
  EXPECT_EQ(spherePlace({}, Vector3::Zero()), Vector3(0, 0, 1));
}

TEST(RotationProjection, ATurnLiesHalfItsAngleFromThePoleTowardsItsAxis)
{
  for (const double degrees : {10.0, 45.0, 180.0, 270.0, 359.0}) {
    const double half = degrees / 360 * std::numbers::pi;
    const Vector3 place = spherePlace({}, rotationLog({0, 2, 0}, degrees));
    EXPECT_NEAR((place - Vector3(0, std::sin(half), std::cos(half))).norm(), 0, kRounding) << degrees;
  }
}

TEST(RotationProjection, TurnsAboutAxesOfOnePlaneLieOnTheUnitSphere)
{
  const SphereFrame frame = hiding(Vector3(1, 2, -2) / 3);
  for (int k = 0; k < 36; ++k) {
    const Vector3 axis = std::cos(k) * frame.axes.col(0) + std::sin(k) * frame.axes.col(1);
    EXPECT_NEAR(spherePlace(frame, rotationLog(axis, 10 * k)).norm(), 1, kRounding) << k;
  }
}

TEST(RotationProjection, WhatLeavesThePlaneIsBelowTheSurface)
{
  const SphereFrame frame;
  EXPECT_LT(spherePlace(frame, rotationLog({0, 0, 1}, 90)).norm(), 0.8);
}

TEST(RotationProjection, NoTwoAnglesAboutOneAxisShareAPlace)
{
  // Up to five turns; within one turn distances on the sphere, from turn to turn the shells set them apart.
  std::vector<Vector3> places;
  for (int degrees = 0; degrees <= 1800; degrees += 15)
    places.push_back(spherePlace({}, rotationLog({1, 0, 0}, degrees)));
  for (std::size_t a = 0; a < places.size(); ++a)
    for (std::size_t b = a + 1; b < places.size(); ++b)
      EXPECT_GT((places[a] - places[b]).norm(), 0.1) << 15 * a << " and " << 15 * b << " degrees";
}

TEST(RotationProjection, TheWholeTurnIsTheOtherPoleAndTheNextOneRises)
{
  EXPECT_NEAR((spherePlace({}, rotationLog({1, 0, 0}, 360)) - Vector3(0, 0, -1)).norm(), 0, kRounding);
  EXPECT_NEAR((spherePlace({}, rotationLog({1, 0, 0}, 720)) - Vector3(0, 0, 1 + kTurnRise)).norm(), 0, kRounding);
}

TEST(RotationProjection, BlendsOfOneHandleAndNothingLieOnTheirArc)
{
  const Vector3 q = rotationLog({1, 2, 0}, 200);
  const std::vector<Vector3> arc = sphereArc({}, Vector3::Zero(), q);
  ASSERT_GT(arc.size(), 10);
  const Vector3 plane = arc.front().cross(spherePlace({}, q / 2)).normalized();
  for (const Vector3& place : arc) {
    EXPECT_NEAR(place.dot(plane), 0, kRounding);
    EXPECT_NEAR(place.norm(), 1, kRounding);
  }
  EXPECT_NEAR((arc.back() - spherePlace({}, q)).norm(), 0, kRounding);
}

TEST(RotationProjection, ArcsBetweenTwoHandlesAreGreatCircles)
{
  const Vector3 a = rotationLog({1, 0, 0}, 120);
  const Vector3 b = rotationLog({0, 1, 0}, 80);
  const std::vector<Vector3> arc = sphereArc({}, a, b);
  const Vector3 plane = spherePlace({}, a).cross(spherePlace({}, b)).normalized();
  EXPECT_NEAR((arc.front() - spherePlace({}, a)).norm(), 0, kRounding);
  EXPECT_NEAR((arc.back() - spherePlace({}, b)).norm(), 0, kRounding);
  for (std::size_t k = 1; k < arc.size(); ++k) {
    EXPECT_NEAR(arc[k].dot(plane), 0, kRounding);
    EXPECT_NEAR((arc[k] - arc[k - 1]).norm(), (arc[1] - arc[0]).norm(), kRounding) << "equal steps";
  }
}

TEST(RotationProjection, TheFrameShowsTheAxesOfUpToTwoHandlesWhole)
{
  const std::vector<BoundaryRotation> boundary{{Vector3::Zero(), ""}, {{0.1, 0.7, 0.3}, ""}, {{-0.4, 0.2, 0.9}, ""}};
  const SphereFrame frame = sphereFrame(boundary, {});
  for (const BoundaryRotation& value : boundary) EXPECT_NEAR(spherePlace(frame, value.q).norm(), 1, kRounding);
  EXPECT_NEAR((frame.axes.transpose() * frame.axes - Eigen::Matrix3d::Identity()).norm(), 0, kRounding);
  EXPECT_NEAR(frame.axes.determinant(), 1, kRounding);
}

TEST(RotationProjection, TheFrameStaysWhileItShowsAboutAsMuch)
{
  const SphereFrame before = sphereFrame({{{1, 0, 0}, ""}, {{0, 1, 0}, ""}}, {});
  EXPECT_EQ(sphereFrame({{{1, 0, 0.05}, ""}, {{0, 1, 0}, ""}}, before).axes, before.axes);
  EXPECT_NE(sphereFrame({{{1, 0, 0.9}, ""}, {{0, 1, 0}, ""}}, before).axes, before.axes);
  EXPECT_EQ(sphereFrame({{Vector3::Zero(), ""}}, before).axes, before.axes);
}

TEST(RotationProjection, EachPrescribedRotationIsNamedByItsConstraintsOnce)
{
  const Model model = makeModel(test::grid(4, 4), "grid");
  const AxisRotation turn{Vector3::UnitX(), 90, {}};
  const ConstraintList list{"",
                            {{"left", true, FixedConstraint{{VertexIds{{0, 1}}}}},
                             {"tip", true, HandleConstraint{{VertexIds{{23, 24}}}, turn, Vector3::Zero(), {}}},
                             {"right", true, FixedConstraint{{VertexIds{{4}}}}},
                             {"off", false, FixedConstraint{{VertexIds{{5}}}}}}};
  NoProgress progress;
  const auto boundary = boundaryRotations(deform(model, list, "constraints", {}, progress));
  ASSERT_EQ(boundary.size(), 2);
  EXPECT_EQ(boundary[0].label, "left, right");
  EXPECT_EQ(boundary[0].q, Vector3(0, 0, 0));
  EXPECT_EQ(boundary[1].label, "tip");
  EXPECT_NEAR(angleDegrees(boundary[1].q), 90, 1e-12);
  EXPECT_TRUE(hasRotation(boundary));
  EXPECT_FALSE(hasRotation({boundary[0]}));
}

}  // namespace
}  // namespace holdfast
