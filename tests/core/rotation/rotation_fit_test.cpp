#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <holdfast/geometry/rotation_fit.h>
#include <holdfast/geometry/rotation_log.h>

#include "support/meshes.h"
#include "support/point_constraints.h"

namespace holdfast {
namespace {

using test::Random;
using test::randomVector;

Positions randomPoints(Random& random, Index count)
{
  Positions points(count, 3);
  for (Index k = 0; k < count; ++k) points.row(k) = randomVector(random, 1);
  return points;
}

Eigen::Matrix3d randomRotation(Random& random)
{
  return rotationMatrix(randomVector(random, 1), random.uniform(-180, 180));
}

Positions moved(const Positions& points, const Eigen::Matrix3d& R, const Vector3& shift)
{
  return (points * R.transpose()).rowwise() + shift.transpose();
}

double maxNormDistance(const Eigen::Matrix3d& A, const Eigen::Matrix3d& B)
{
  return (A - B).cwiseAbs().maxCoeff();
}

void expectRotation(const Eigen::Matrix3d& R)
{
  EXPECT_LE(maxNormDistance(R * R.transpose(), Eigen::Matrix3d::Identity()), 1e-14);
  EXPECT_GT(R.determinant(), 0);
}

/// What R leaves, by its definition.
double residualOf(const Eigen::Matrix3d& R, const Positions& points, const Positions& targets)
{
  const Vector3 pMean = points.colwise().mean();
  const Vector3 tMean = targets.colwise().mean();
  double sum = 0;
  for (Index k = 0; k < points.rows(); ++k)
    sum += (R * (points.row(k).transpose() - pMean) - (targets.row(k).transpose() - tMean)).squaredNorm();
  return std::sqrt(sum / static_cast<double>(points.rows()));
}

TEST(FitRotation, FindsTheRotationOfARigidMotion)
{
  for (std::uint32_t seed = 0; seed < 100; ++seed) {
    Random random(seed);
    const Positions points = randomPoints(random, random.integer(3, 20));
    const Eigen::Matrix3d R = randomRotation(random);
    const Positions targets = moved(points, R, randomVector(random, 10));
    const RotationFit fit = fitRotation(points, targets);
    EXPECT_LE(maxNormDistance(fit.R, R), 1e-12);
    EXPECT_TRUE(fit.isDetermined);
    EXPECT_LE(residualOf(fit.R, points, targets), 1e-13);
  }
}

TEST(FitRotation, DoesNotDependOnTheScaleOfEitherSet)
{
  Random random(1);
  const Positions points = randomPoints(random, 6);
  const Eigen::Matrix3d R = randomRotation(random);
  for (const double scale : {1e-200, 1e-6, 1e6, 1e200}) {
    const RotationFit fit = fitRotation(scale * points, moved(points, R, Vector3::Zero()) / scale);
    EXPECT_LE(maxNormDistance(fit.R, R), 1e-14);
    EXPECT_TRUE(fit.isDetermined);
  }
}

TEST(FitRotation, LeavesLessThanEveryOtherRotation)
{
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    Random random(seed);
    const Positions points = randomPoints(random, 5);
    const Positions targets = randomPoints(random, 5);
    const RotationFit fit = fitRotation(points, targets);
    expectRotation(fit.R);
    const double least = residualOf(fit.R, points, targets);
    for (int k = 0; k < 200; ++k) {
      const Eigen::Matrix3d nearby = rotationMatrix(randomVector(random, 1e-3)) * fit.R;
      EXPECT_GE(residualOf(nearby, points, targets), least - 1e-14);
      EXPECT_GE(residualOf(randomRotation(random), points, targets), least);
    }
  }
}

TEST(FitRotation, OfAMirrorImageIsStillARotation)
{
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    Random random(seed);
    const Positions points = randomPoints(random, 8);
    const RotationFit fit = fitRotation(points, -points);
    expectRotation(fit.R);
    EXPECT_TRUE(fit.isDetermined);
    EXPECT_GT(residualOf(fit.R, points, -points), 0.01);
  }
}

TEST(FitRotation, OfFlatPointsIsDetermined)
{
  Random random(3);
  Positions points = randomPoints(random, 4);
  points.col(2).setZero();
  const Eigen::Matrix3d R = randomRotation(random);
  const RotationFit fit = fitRotation(points, moved(points, R, Vector3::Ones()));
  EXPECT_LE(maxNormDistance(fit.R, R), 1e-14);
  EXPECT_TRUE(fit.isDetermined);
}

TEST(FitRotation, FarFromTheOriginLosesOnlyWhatTheCoordinatesLose)
{
  Random random(4);
  const Positions points = randomPoints(random, 10);
  const Eigen::Matrix3d R = randomRotation(random);
  const Vector3 far(1e6, -2e6, 3e6);
  const RotationFit fit = fitRotation(moved(points, Eigen::Matrix3d::Identity(), far), moved(points, R, -far));
  EXPECT_LE(maxNormDistance(fit.R, R), 1e-9);
  EXPECT_TRUE(fit.isDetermined);
}

TEST(FitRotation, OfPointsOnALineIsTheShortestThatFitsAndNotDetermined)
{
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    Random random(seed);
    const Vector3 from = randomVector(random, 1);
    const Vector3 to = randomVector(random, 1).normalized() * from.norm();
    Positions points(4, 3);
    Positions targets(4, 3);
    for (Index k = 0; k < 4; ++k) {
      const double t = random.uniform(-1, 1);
      points.row(k) = t * from + Vector3(1, 2, 3);
      targets.row(k) = t * to - Vector3(3, 1, 2);
    }
    const RotationFit fit = fitRotation(points, targets);
    EXPECT_FALSE(fit.isDetermined);
    expectRotation(fit.R);
    EXPECT_LE(residualOf(fit.R, points, targets), 1e-14);
    EXPECT_NEAR(angleDegrees(rotationLog(fit.R)),
                std::acos(from.normalized().dot(to.normalized())) * 180 / std::numbers::pi, 1e-6);
  }
}

TEST(FitRotation, OfPointsOnALineToABodyFollowsTheMainDirection)
{
  Positions points(3, 3);
  points << 0, 0, 0, 1, 0, 0, 3, 0, 0;
  Positions targets(3, 3);
  targets << 0, 0, 0, 0, 1, 0.2, 0, 3, -0.1;
  const RotationFit fit = fitRotation(points, targets);
  EXPECT_FALSE(fit.isDetermined);
  EXPECT_NEAR(fit.R.col(0).y(), 1, 0.01);
  for (const double degrees : {-1.0, 1.0})
    EXPECT_GT(residualOf(rotationMatrix(Vector3(1, 0, 0), degrees) * fit.R, points, targets),
              residualOf(fit.R, points, targets));
}

TEST(FitRotation, OfCoincidingPointsIsNone)
{
  const Positions one = Positions::Constant(3, 3, 0.1);
  Random random(5);
  for (const Positions& targets : {one, randomPoints(random, 3)}) {
    const RotationFit fit = fitRotation(one, targets);
    EXPECT_EQ(fit.R, Eigen::Matrix3d::Identity());
    EXPECT_FALSE(fit.isDetermined);
  }
  EXPECT_FALSE(fitRotation(one.topRows(1), one.topRows(1)).isDetermined);
}

TEST(FitRotation, ToTheMirrorImageOfACubeIsNotDetermined)
{
  const Positions cube = test::box(Vector3(1, 1, 1), 1).positions;
  const RotationFit fit = fitRotation(cube, -cube);
  EXPECT_FALSE(fit.isDetermined);
  expectRotation(fit.R);
}

TEST(ShortestRotation, TakesOneDirectionToTheOtherAndTurnsNoMoreThanTheirAngle)
{
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    Random random(seed);
    const Vector3 a = randomVector(random, 1).normalized();
    // From beside `a` to beside its opposite, down to 1e-14 from either.
    const Vector3 off = randomVector(random, 1).cross(a) * std::pow(10, random.uniform(-14, 0));
    for (const double side : {1.0, -1.0}) {
      const Vector3 b = (side * a + off).normalized();
      const DirectionTurn turn = shortestRotation(3 * a, 1e-5 * b);
      EXPECT_TRUE(turn.isDetermined);
      EXPECT_NEAR(turn.rotation.norm(), 1, 1e-15);
      EXPECT_LE((turn.rotation * a - b).norm(), 2e-15);
      const double angle = 2 * std::atan2((a - b).norm(), (a + b).norm());
      EXPECT_NEAR(2 * rotationLog(turn.rotation).norm(), angle, 2e-15);
    }
  }
}

TEST(ShortestRotation, OfOneDirectionToItselfIsNone)
{
  const DirectionTurn turn = shortestRotation(Vector3(1, 2, 3), Vector3(2, 4, 6));
  EXPECT_TRUE(turn.isDetermined);
  EXPECT_EQ(turn.rotation.vec(), Vector3::Zero());
  EXPECT_NEAR(shortestRotation(Vector3::UnitX(), Vector3(1, 1e-300, 0)).rotation.z() / 5e-301, 1, 1e-15);
}

TEST(ShortestRotation, OfOppositeDirectionsIsSomeHalfTurnAndNotDetermined)
{
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    Random random(seed);
    for (const Vector3& a : {randomVector(random, 1), Vector3(0, -2, 0), Vector3(1e-200, 0, 0)}) {
      const DirectionTurn turn = shortestRotation(a, -3 * a);
      EXPECT_FALSE(turn.isDetermined);
      EXPECT_LE((turn.rotation * a.stableNormalized() + a.stableNormalized()).norm(), 2e-15);
      EXPECT_EQ(turn.rotation.coeffs(), shortestRotation(a, -3 * a).rotation.coeffs());
    }
  }
}

TEST(FittedRotation, FindsTheBestRotationFromOneNearIt)
{
  Random random(7);
  for (int k = 0; k < 2000; ++k) {
    const Eigen::Matrix3d turn = rotationMatrix(randomVector(random, 3));
    Eigen::Matrix3d points;
    for (int c = 0; c < 3; ++c) points.col(c) = randomVector(random, 1);
    Eigen::Matrix3d noise;
    for (int c = 0; c < 3; ++c) noise.col(c) = randomVector(random, 0.2 * (k % 5));
    const Eigen::Matrix3d H = (turn * points + noise) * points.transpose();
    const Eigen::Quaterniond near = rotationExp(randomVector(random, 2));
    const Eigen::Matrix3d R = fittedRotation(H, near).toRotationMatrix();
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(H, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const double sign = (svd.matrixU() * svd.matrixV().transpose()).determinant() > 0 ? 1 : -1;
    const Vector3& s = svd.singularValues();
    EXPECT_NEAR((R.transpose() * H).trace(), s[0] + s[1] + sign * s[2], 1e-12 * s[0]) << k;
    EXPECT_NEAR(R.determinant(), 1, 1e-14);
    if (k % 5 == 0) {
      EXPECT_LE((R - turn).cwiseAbs().maxCoeff(), 1e-9) << k;
    }
  }
}

/// The most that trace(R^T H) can be: the sum of the singular values, the least with the sign of the determinant.
double mostTrace(const Eigen::Matrix3d& H)
{
  const Vector3 s = Eigen::JacobiSVD<Eigen::Matrix3d>(H).singularValues();
  return s[0] + s[1] + (H.determinant() < 0 ? -s[2] : s[2]);
}

/// Symmetric, with these eigenvalues of trace(M) I - M along random axes.
Eigen::Matrix3d withCurvatures(Random& random, const Vector3& k)
{
  const Eigen::Matrix3d axes = randomRotation(random);
  const Vector3 m = Vector3::Constant(k.sum() / 2) - k;
  return axes * m.asDiagonal() * axes.transpose();
}

TEST(FittedRotation, LeavesASaddleWithTwoFallingDirections)
{
  // K has a positive trace and determinant there, and is not definite: Newton's method would stay, or come nearer.
  Random random(8);
  for (int k = 0; k < 300; ++k) {
    const Vector3 curvatures(random.uniform(4, 8), -random.uniform(0.1, 1.5), -random.uniform(0.1, 1.5));
    const Eigen::Quaterniond near = rotationExp(randomVector(random, 2));
    const Eigen::Quaterniond off = rotationExp(randomVector(random, k % 3 == 0 ? 0 : 1e-3 * k));
    const Eigen::Matrix3d H = (near * off).toRotationMatrix() * withCurvatures(random, curvatures);
    const Eigen::Matrix3d R = fittedRotation(H, near).toRotationMatrix();
    EXPECT_NEAR((R.transpose() * H).trace(), mostTrace(H), 1e-12 * mostTrace(H)) << k;
  }
}

TEST(FittedRotation, LeavesASaddleWithOneFallingDirectionAndLeastValues)
{
  Random random(9);
  for (int k = 0; k < 300; ++k) {
    const bool isLeast = k % 2 == 0;
    const Vector3 curvatures(isLeast ? -random.uniform(1, 2) : random.uniform(1, 3),
                             isLeast ? -random.uniform(1, 2) : random.uniform(1, 3), -random.uniform(0.1, 0.9));
    const Eigen::Quaterniond near = rotationExp(randomVector(random, 2));
    const Eigen::Matrix3d H = near.toRotationMatrix() * withCurvatures(random, curvatures);
    const Eigen::Matrix3d R = fittedRotation(H, near).toRotationMatrix();
    EXPECT_NEAR((R.transpose() * H).trace(), mostTrace(H), 1e-12 * H.norm()) << k;
  }
}

TEST(FittedRotation, StaysWhereItIsWhereNothingIsBetter)
{
  const Eigen::Quaterniond near = rotationExp(Vector3(0.3, -0.2, 0.5));
  const Vector3 a(1, 2, 3);
  EXPECT_EQ(fittedRotation(Eigen::Matrix3d::Zero(), near).coeffs(), near.coeffs());
  // Of all rotations that take a line to a line, the one that differs least.
  const Vector3 b = near * a;
  EXPECT_LE(fittedRotation(b * a.transpose(), near).angularDistance(near), 1e-7);
  const Eigen::Matrix3d symmetric = a * a.transpose() + 2 * Eigen::Matrix3d::Identity();
  EXPECT_EQ(fittedRotation(symmetric, Eigen::Quaterniond::Identity()).coeffs(),
            Eigen::Quaterniond::Identity().coeffs());
}

}  // namespace
}  // namespace holdfast
