#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <holdfast/operators/cotangents.h>

#include "support/law_meshes.h"
#include "support/meshes.h"
#include "support/point_constraints.h"

namespace holdfast {
namespace {

Positions triangleAt(const Vector3& a, const Vector3& b, const Vector3& c)
{
  Positions positions(3, 3);
  positions << a.transpose(), b.transpose(), c.transpose();
  return positions;
}

double areaOf(const Positions& positions, const std::vector<Triangle>& triangles)
{
  double sum = 0;
  for (const auto& [a, b, c] : triangles) {
    const Vector3 ab = positions.row(b) - positions.row(a);
    const Vector3 ac = positions.row(c) - positions.row(a);
    sum += ab.cross(ac).norm() / 2;
  }
  return sum;
}

TEST(Cotangents, AreThoseOfTheAngles)
{
  const CornerCotangents right = cornerCotangents(triangleAt({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), {0, 1, 2});
  EXPECT_DOUBLE_EQ(right[0], 0);
  EXPECT_DOUBLE_EQ(right[1], 1);
  EXPECT_DOUBLE_EQ(right[2], 1);
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    test::Random random(seed);
    const Positions p =
        triangleAt(test::randomVector(random, 1), test::randomVector(random, 1), test::randomVector(random, 1));
    const CornerCotangents cot = cornerCotangents(p, {0, 1, 2});
    // The angles sum to two right ones: cot a cot b + cot b cot c + cot c cot a = 1.
    const double largest = std::max({std::abs(cot[0]), std::abs(cot[1]), std::abs(cot[2])});
    EXPECT_NEAR(cot[0] * cot[1] + cot[1] * cot[2] + cot[2] * cot[0], 1, 1e-13 * largest * largest + 1e-14);
  }
}

TEST(Cotangents, OfTrianglesWithoutAreaAreNotFinite)
{
  for (const double cot : cornerCotangents(triangleAt({0, 0, 0}, {1, 0, 0}, {3, 0, 0}), {0, 1, 2}))
    EXPECT_FALSE(std::isfinite(cot));
  for (const double cot : cornerCotangents(Positions::Zero(3, 3), {0, 1, 2})) EXPECT_TRUE(std::isnan(cot));
}

/// The figures of docs/math.md.
TEST(GuardedCotangents, AreHeldWithinTwentyAndOtherwiseUnchanged)
{
  const double inf = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(guarded({inf, -inf, 1e9}), (CornerCotangents{20, -20, 20}));
  EXPECT_EQ(guarded({0.5, -0.25, 19.99}), (CornerCotangents{0.5, -0.25, 19.99}));
  for (const double cot : guarded({nan, nan, nan})) EXPECT_DOUBLE_EQ(std::atan(1 / cot), std::numbers::pi / 3);
}

TEST(GuardedCotangents, AreThoseOfAnglesAbove2Point9Degrees)
{
  for (const double degrees : {2.85, 2.87}) {
    const double height = std::tan(degrees * std::numbers::pi / 180);
    const CornerCotangents plain = cornerCotangents(triangleAt({0, 0, 0}, {1, 0, 0}, {1, height, 0}), {0, 1, 2});
    EXPECT_EQ(guarded(plain) == plain, degrees > 2.86) << plain[0];
  }
}

TEST(MixedAreas, ArePositiveAndSumToTheAreaOfTheMesh)
{
  for (const test::NamedMesh& named : test::lawMeshes()) {
    SCOPED_TRACE(named.name);
    const std::vector<Triangle> triangles = triangulate(named.mesh).triangles;
    const Eigen::VectorXd areas = mixedVoronoiAreas(named.mesh.positions, triangles);
    const double area = areaOf(named.mesh.positions, triangles);
    EXPECT_GT(areas.minCoeff(), 0);
    EXPECT_NEAR(areas.sum(), area, 1e-13 * area);
  }
}

TEST(MixedAreas, NeverAreNegativeOnObtuseTrianglesAndSlivers)
{
  for (std::uint32_t seed = 0; seed < 100; ++seed) {
    test::Random random(seed);
    const Positions p =
        triangleAt({0, 0, 0}, {1, 0, 0}, {random.uniform(-3, 3), std::pow(10, random.uniform(-12, 0)), 0});
    const Eigen::VectorXd areas = mixedVoronoiAreas(p, {{0, 1, 2}});
    EXPECT_GE(areas.minCoeff(), 0);
    EXPECT_NEAR(areas.sum(), p(2, 1) / 2, 1e-12 * p(2, 1));
  }
  EXPECT_EQ(mixedVoronoiAreas(triangleAt({0, 0, 0}, {1, 0, 0}, {3, 0, 0}), {{0, 1, 2}}), Vector3::Zero());
  EXPECT_EQ(mixedVoronoiAreas(Positions::Zero(3, 3), {{0, 1, 2}}), Vector3::Zero());
}

TEST(LiteralAreas, AgreeWithMixedOnesWhereNoAngleIsObtuse)
{
  const Mesh mesh = test::icosphere(2);
  const std::vector<Triangle> triangles = triangulate(mesh).triangles;
  EXPECT_LT((mixedVoronoiAreas(mesh.positions, triangles) - literalVoronoiAreas(mesh.positions, triangles))
                .cwiseAbs()
                .maxCoeff(),
            1e-15);
}

TEST(LiteralAreas, AreNegativeBesideAnObtuseAngleYetSumToTheArea)
{
  const Positions p = triangleAt({0, 0, 0}, {1, 0, 0}, {0.5, 0.1, 0});
  const Eigen::VectorXd areas = literalVoronoiAreas(p, {{0, 1, 2}});
  EXPECT_LT(areas.minCoeff(), 0);
  EXPECT_NEAR(areas.sum(), 0.05, 1e-15);
}

}  // namespace
}  // namespace holdfast
