#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <holdfast/geometry/rotation_log.h>

#include "support/point_constraints.h"
#include "support/rounding.h"

namespace holdfast {
namespace {

using std::numbers::pi;
using test::kEpsilon;
using test::Random;
using test::randomVector;
using Long3 = Eigen::Matrix<long double, 3, 1>;
using Long33 = Eigen::Matrix<long double, 3, 3>;

Vector3 randomAxis(Random& random)
{
  Vector3 axis = randomVector(random, 1);
  while (axis.norm() < 0.1) axis = randomVector(random, 1);
  return axis.normalized();
}

/// A log of any direction whose length is spread evenly over the powers of ten from 1e-300 to `most`.
Vector3 randomLog(Random& random, double most)
{
  return randomAxis(random) * std::pow(10, random.uniform(-300, std::log10(most)));
}

/// A log of any direction and a length up to `most`.
Vector3 randomTurns(Random& random, double most)
{
  return randomAxis(random) * random.uniform(0, most);
}

/// The exponential series of the matrix of w -> 2 q x w in long double, after halving the angle until it is small.
Long33 exponentialSeries(const Vector3& q)
{
  Long3 w = 2 * q.cast<long double>();
  int halvings = 0;
  for (; w.norm() > 0.1L; ++halvings) w /= 2;
  Long33 W;
  W << 0, -w.z(), w.y(), w.z(), 0, -w.x(), -w.y(), w.x(), 0;
  Long33 term = Long33::Identity();
  Long33 sum = term;
  for (int k = 1; k < 20; ++k) {
    term = term * W / static_cast<long double>(k);
    sum += term;
  }
  for (; halvings > 0; --halvings) sum = Long33(sum * sum);
  return sum;
}

template <class Check>
void forEachRandomLog(Check&& check)
{
  for (std::uint32_t seed = 0; seed < 300; ++seed) {
    Random random(seed);
    check(randomLog(random, 1));
    check(randomTurns(random, 100));
  }
}

TEST(RotationExp, IsTheQuaternionOfTheAngleFromTheSmallestToManyTurns)
{
  forEachRandomLog([](const Vector3& q) {
    const Long3 precise = q.cast<long double>();
    const long double half = precise.norm();
    const Long3 v = precise * (std::sin(half) / half);
    const Eigen::Quaterniond found = rotationExp(q);
    const double rounding = 4 * kEpsilon * q.stableNorm();
    EXPECT_NEAR(found.w(), static_cast<double>(std::cos(half)), rounding + kEpsilon) << q.transpose();
    EXPECT_LE((found.vec() - v.cast<double>()).stableNorm(), rounding) << q.transpose();
  });
  EXPECT_EQ(rotationExp(Vector3::Zero()).coeffs(), Eigen::Quaterniond::Identity().coeffs());
}

TEST(RotationMatrix, IsTheExponentialSeriesFromTheSmallestToManyTurns)
{
  forEachRandomLog([](const Vector3& q) {
    const Long33 exact = exponentialSeries(q);
    const Eigen::Matrix3d found = rotationMatrix(q);
    EXPECT_LE((found - exact.cast<double>()).cwiseAbs().maxCoeff(), 8 * kEpsilon * (1 + 2 * q.norm())) << q.transpose();
    const Eigen::Matrix3d odd = found - found.transpose();
    const Eigen::Matrix3d exactOdd = (exact - exact.transpose()).cast<double>();
    EXPECT_LE((odd - exactOdd).cwiseAbs().maxCoeff(), 16 * kEpsilon * q.stableNorm()) << "sines " << q.transpose();
  });
}

TEST(RotationMatrix, AgreesWithTheQuaternion)
{
  forEachRandomLog([](const Vector3& q) {
    EXPECT_LE((rotationMatrix(q) - rotationExp(q).toRotationMatrix()).cwiseAbs().maxCoeff(),
              8 * kEpsilon * (1 + 2 * q.norm()))
        << q.transpose();
  });
}

TEST(RotationMatrix, QuarterTurnsAboutCoordinateAxesAreExact)
{
  for (int axis = 0; axis < 3; ++axis)
    for (int quarters = -9; quarters <= 9; ++quarters) {
      SCOPED_TRACE(testing::Message() << quarters << " quarter turns about axis " << axis);
      const Eigen::Matrix3d one =
          Eigen::Matrix3d(Eigen::AngleAxisd(pi / 2, Vector3::Unit(axis))).array().round().matrix();
      Eigen::Matrix3d expected = Eigen::Matrix3d::Identity();
      for (int k = 0; k < ((quarters % 4) + 4) % 4; ++k) expected = expected * one;
      EXPECT_EQ(rotationMatrix(Vector3::Unit(axis), 90 * quarters), expected);
      EXPECT_EQ(rotationMatrix(-7 * Vector3::Unit(axis), -90 * quarters), expected);
      EXPECT_EQ(rotationMatrix(rotationLog(Vector3::Unit(axis), 90 * quarters)), expected);
    }
}

TEST(RotationMatrix, TakesAxesOfAnyLength)
{
  const Vector3 axis(1, -2, 2);
  const Eigen::Matrix3d expected(Eigen::AngleAxisd(50 * pi / 180, axis / 3));
  for (const double length : {1e-320, 1e-200, 1.0, 1e200, 1e307})
    EXPECT_LE((rotationMatrix(length * axis, 50) - expected).cwiseAbs().maxCoeff(), length < 1e-300 ? 1e-3 : 1e-15);
  EXPECT_EQ(rotationMatrix(Vector3::Zero(), 50), Eigen::Matrix3d::Identity());
  EXPECT_EQ(rotationMatrix(Vector3::Zero()), Eigen::Matrix3d::Identity());
}

TEST(ShiftByRotation, HasItsDigitsFromTheSmallestToManyTurns)
{
  const Vector3 x(0.3, -2, 1);
  forEachRandomLog([&](const Vector3& q) {
    const long double half = q.cast<long double>().norm();
    const Long3 axis = q.cast<long double>() / half;
    const Long3 across = axis.cross(x.cast<long double>());
    const Long3 exact = 2 * std::sin(half) * (std::cos(half) * across + std::sin(half) * axis.cross(across));
    EXPECT_LE((shiftByRotation(q, x) - exact.cast<double>()).stableNorm(), 16 * kEpsilon * q.stableNorm() * x.norm())
        << q.transpose();
  });
  EXPECT_EQ(shiftByRotation(Vector3::Zero(), x), Vector3::Zero());
  EXPECT_EQ(shiftByRotation(rotationLog(Vector3::UnitZ(), 90), x), Vector3(-x.y() - x.x(), x.x() - x.y(), 0));
}

TEST(RotationLog, UndoesTheExponential)
{
  for (std::uint32_t seed = 0; seed < 500; ++seed) {
    Random random(seed);
    for (const Vector3& q : {randomLog(random, 1), randomTurns(random, 1.57)}) {
      EXPECT_LE((rotationLog(rotationExp(q)) - q).stableNorm(), 8 * kEpsilon * q.stableNorm()) << q.transpose();
      EXPECT_LE((rotationLog(rotationMatrix(q)) - q).stableNorm(), 16 * kEpsilon * q.stableNorm()) << q.transpose();
    }
  }
}

TEST(RotationLog, OfAMatrixIsAxisAndHalfAngle)
{
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    Random random(seed);
    const Vector3 axis = randomAxis(random);
    const double angle = random.uniform(0, pi);
    const Eigen::Matrix3d R(Eigen::AngleAxisd(angle, axis));
    EXPECT_LE((rotationLog(R) - angle / 2 * axis).norm(), 1e-15);
  }
}

TEST(RotationLog, OfARotationDoesNotDependOnTheSignOfItsQuaternion)
{
  const auto expectSame = [](const Eigen::Quaterniond& rotation) {
    const Vector3 q = rotationLog(rotation);
    EXPECT_EQ(rotationLog(Eigen::Quaterniond(-rotation.coeffs())), q);
    EXPECT_LE(q.norm(), pi / 2 * (1 + 2 * kEpsilon));
  };
  for (std::uint32_t seed = 0; seed < 100; ++seed) {
    Random random(seed);
    expectSame(rotationExp(randomTurns(random, 10)));
    const Vector3 axis = randomAxis(random);
    expectSame({0, axis.x(), axis.y(), axis.z()});
  }
  expectSame({0, 0, -1, 0});
  expectSame({0, 0, 0, 1});
}

TEST(RotationLog, KeepsAllDigitsBesideWholeTurns)
{
  EXPECT_EQ(rotationLog(Eigen::Quaterniond(1, 0, 1e-300, 0)), Vector3(0, 1e-300, 0));
  EXPECT_EQ(rotationLog(Eigen::Quaterniond(-1, 0, 1e-300, 0)), Vector3(0, -1e-300, 0));
  EXPECT_EQ(rotationLog(Eigen::Quaterniond(-1, 3e-20, 0, 0)), Vector3(-3e-20, 0, 0));
  EXPECT_EQ(rotationLog(Eigen::Quaterniond(-1, 0, 0, 0)), Vector3::Zero());
  const Vector3 small(1e-9, 2e-9, -3e-9);
  const Vector3 q = small.normalized() * (pi - small.norm());
  EXPECT_LE((rotationLog(rotationExp(q)) + small).norm(), 4 * kEpsilon * pi);
}

TEST(RotationLog, OfDegreesIsNotWrapped)
{
  for (const double degrees : {0.0, 30.0, 180.0, 270.0, 360.0, 720.0, -450.0, 1e-290}) {
    const Vector3 q = rotationLog(Vector3(0, 0, 5), degrees);
    EXPECT_NEAR(q.z(), degrees * pi / 360, 2 * kEpsilon * std::abs(degrees * pi / 360));
    EXPECT_EQ(q.head<2>(), Eigen::Vector2d::Zero());
    EXPECT_NEAR(angleDegrees(q), std::abs(degrees), 4 * kEpsilon * std::abs(degrees));
  }
  EXPECT_EQ(rotationLog(Vector3::Zero(), 90), Vector3::Zero());
}

TEST(RotationLogNear, IsALogOfTheRotationAndNoOtherIsNearer)
{
  for (std::uint32_t seed = 0; seed < 300; ++seed) {
    Random random(seed);
    const Eigen::Quaterniond rotation = rotationExp(randomTurns(random, 1.5));
    const Vector3 reference = randomTurns(random, 20);
    const Vector3 q = rotationLogNear(rotation, reference);
    EXPECT_LE((rotationMatrix(q) - rotation.toRotationMatrix()).cwiseAbs().maxCoeff(), 1e-13);
    const Vector3 shortest = rotationLog(rotation);
    for (int k = -10; k <= 10; ++k)
      EXPECT_LE((q - reference).norm(),
                (shortest.normalized() * (shortest.norm() + k * pi) - reference).norm() + 1e-13);
  }
}

TEST(RotationLogNear, CountsTheTurnsOfADrag)
{
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    Random random(seed);
    const Vector3 axis = randomAxis(random);
    Vector3 tracked = Vector3::Zero();
    for (int degrees = 0; degrees <= 1440; degrees += 15) {
      tracked = rotationLogNear(rotationExp(rotationLog(axis, degrees % 360)), tracked);
      EXPECT_NEAR(angleDegrees(tracked), degrees, 1e-11);
      EXPECT_LE((tracked - rotationLog(axis, degrees)).norm(), 1e-13);
    }
    for (int degrees = 1440; degrees >= -720; degrees -= 15)
      tracked = rotationLogNear(rotationExp(rotationLog(axis, degrees % 360)), tracked);
    EXPECT_LE((tracked - rotationLog(axis, -720)).norm(), 1e-13);
  }
}

TEST(RotationLogNear, OfNoRotationGoesAboutTheAxisOfTheReference)
{
  const Vector3 twice = rotationLog(Vector3(1, 2, 2), 720);
  const Eigen::Quaterniond none = Eigen::Quaterniond::Identity();
  EXPECT_LE((rotationLogNear(none, 1.1 * twice) - twice).norm(), 1e-14);
  EXPECT_LE((rotationLogNear(Eigen::Quaterniond(-1, 1e-17, 0, 0), 0.9 * twice) - twice).norm(), 1e-14);
  EXPECT_EQ(rotationLogNear(none, 0.2 * twice), Vector3::Zero());
  EXPECT_EQ(rotationLogNear(none, Vector3::Zero()), Vector3::Zero());
  EXPECT_EQ(rotationLogNear(Eigen::Quaterniond(1, 0, 1e-300, 0), Vector3::Zero()), Vector3(0, 1e-300, 0));
}

}  // namespace
}  // namespace holdfast
