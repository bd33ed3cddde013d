#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <holdfast/geometry/enclosing_sphere.h>

#include "support/law_meshes.h"
#include "support/meshes.h"
#include "support/point_constraints.h"

namespace holdfast {
namespace {

constexpr double kRoundingOfSpheres = 1e-11;

TEST(EnclosingSphere, OfABoxHasItsDiagonalAsDiameter)
{
  EXPECT_NEAR(enclosingDiameter(test::box(Vector3(1, 2, 2), 3).positions), 3, 3 * kRoundingOfSpheres);
  EXPECT_NEAR(enclosingDiameter(test::grid(4, 3).positions), 5, 5 * kRoundingOfSpheres);
  EXPECT_NEAR(enclosingDiameter(test::icosphere(3).positions), 2, 2 * kRoundingOfSpheres);
}

TEST(EnclosingSphere, IsThatOfTheTwoOrThreePointsThatHoldIt)
{
  Positions two(4, 3);
  two << 0, 0, 0, 4, 0, 0, 2, 1, 0, 2, 0, -1.5;
  EXPECT_NEAR(enclosingDiameter(two), 4, kRoundingOfSpheres);
  Positions three(3, 3);  // a triangle of equal sides
  three << 0, 0, 0, 1, 0, 0, 0.5, std::sqrt(0.75), 0;
  EXPECT_NEAR(enclosingDiameter(three), 2 / std::sqrt(3.0), kRoundingOfSpheres);
}

TEST(EnclosingSphere, DoesNotChangeWithRotationsCopiesAndOrder)
{
  test::Random random(5);
  for (const test::NamedMesh& named : test::lawMeshes()) {
    SCOPED_TRACE(named.name);
    const double diameter = enclosingDiameter(named.mesh.positions);
    for (int k = 0; k < 5; ++k) {
      const Eigen::Affine3d motion = Eigen::Translation3d(test::randomVector(random, 3)) *
                                     Eigen::AngleAxisd(k + 0.3, test::randomVector(random, 1).normalized()) *
                                     Eigen::Affine3d::Identity();
      EXPECT_NEAR(enclosingDiameter(test::transformed(named.mesh, motion).positions), diameter,
                  diameter * kRoundingOfSpheres);
    }
    EXPECT_NEAR(enclosingDiameter(test::soup(named.mesh).positions), diameter, diameter * kRoundingOfSpheres);
    const Positions backwards = named.mesh.positions.colwise().reverse();
    EXPECT_NEAR(enclosingDiameter(backwards), diameter, diameter * kRoundingOfSpheres);
  }
}

TEST(EnclosingSphere, HoldsAllPointsAndNoSmallerOneDoes)
{
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    test::Random random(seed);
    Positions points(60, 3);
    for (Index k = 0; k < points.rows(); ++k) points.row(k) = test::randomVector(random, 1).transpose();
    const double diameter = enclosingDiameter(points);
    double farthest = 0;  // of two points: no sphere that holds both is smaller
    for (Index k = 0; k < points.rows(); ++k)
      farthest = std::max(farthest, (points.rowwise() - points.row(k)).rowwise().norm().maxCoeff());
    EXPECT_GE(diameter, farthest * (1 - kRoundingOfSpheres));
    EXPECT_LE(diameter, farthest * std::sqrt(1.5)) << "Jung's theorem";
  }
}

TEST(EnclosingSphere, OfOnePlaceOrNoneIsZero)
{
  EXPECT_EQ(enclosingDiameter(Positions(0, 3)), 0);
  EXPECT_EQ(enclosingDiameter(Positions::Constant(3, 3, 7)), 0);
}

TEST(EnclosingSphere, OfNumbersWhoseSquaresAreNoDoublesIsRight)
{
  for (const double unit : {1e-200, 1e200})
    EXPECT_NEAR(enclosingDiameter(unit * test::box(Vector3(1, 2, 2), 2).positions) / unit, 3, 3 * kRoundingOfSpheres);
}

}  // namespace
}  // namespace holdfast
