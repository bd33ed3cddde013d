#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <holdfast/surface/surface_locator.h>

#include "support/law_meshes.h"
#include "support/meshes.h"
#include "support/point_constraints.h"

namespace holdfast {
namespace {

/// Squared distance to a triangle in the order of dimensions: the plane where the foot falls inside, else the three
/// segments. In long double, by projection matrices in place of barycentric formulas.
long double squaredDistance(const std::array<Vector3, 3>& corners, const Vector3& place)
{
  using Long = Eigen::Matrix<long double, 3, 1>;
  const Long p = place.cast<long double>();
  long double best = (p - corners[0].cast<long double>()).squaredNorm();
  for (int k = 0; k < 3; ++k) {
    const Long a = corners[k].cast<long double>();
    const Long side = corners[(k + 1) % 3].cast<long double>() - a;
    const long double length = side.squaredNorm();
    const long double t = length > 0 ? std::clamp((p - a).dot(side) / length, 0.0L, 1.0L) : 0.0L;
    best = std::min(best, (a + t * side - p).squaredNorm());
  }
  const Long a = corners[0].cast<long double>();
  const Long e = corners[1].cast<long double>() - a;
  const Long f = corners[2].cast<long double>() - a;
  const long double determinant = e.squaredNorm() * f.squaredNorm() - e.dot(f) * e.dot(f);
  if (determinant <= 1e-17L * e.squaredNorm() * f.squaredNorm()) return best;
  const long double s = ((p - a).dot(e) * f.squaredNorm() - (p - a).dot(f) * e.dot(f)) / determinant;
  const long double t = ((p - a).dot(f) * e.squaredNorm() - (p - a).dot(e) * e.dot(f)) / determinant;
  if (s >= 0 && t >= 0 && s + t <= 1) best = std::min(best, (a + s * e + t * f - p).squaredNorm());
  return best;
}

struct Surface {
  Mesh mesh;
  std::vector<Triangle> triangles = triangulate(mesh).triangles;
  ClosestPointSearch search{mesh.positions, triangles};

  [[nodiscard]] double distanceByTryingAll(const Vector3& place) const
  {
    long double best = std::numeric_limits<long double>::infinity();
    for (const auto& [a, b, c] : triangles)
      best =
          std::min(best, squaredDistance({mesh.positions.row(a), mesh.positions.row(b), mesh.positions.row(c)}, place));
    return static_cast<double>(std::sqrt(best));
  }

  /// What is found is canonical, lies on the triangle named, and is as near as any point can be.
  void expectClosest(const Vector3& place) const
  {
    const ClosestPointSearch::Result found = search.find(place);
    EXPECT_NEAR(found.distance, distanceByTryingAll(place), 1e-14 * (1 + found.distance)) << place.transpose();
    EXPECT_NEAR((positionOf(found.point, mesh.positions) - place).norm(), found.distance, 1e-13 * (1 + found.distance));
    double sum = 0;
    for (const Term& term : found.point.terms) {
      const Triangle& triangle = triangles[found.triangle];
      EXPECT_NE(std::find(triangle.begin(), triangle.end(), term.index), triangle.end());
      EXPECT_GT(term.coefficient, 0);
      sum += term.coefficient;
    }
    EXPECT_NEAR(sum, 1, 1e-14);
  }
};

TEST(ClosestPoint, IsTheOneThatTryingAllTrianglesFinds)
{
  for (const test::NamedMesh& named : test::lawMeshes()) {
    SCOPED_TRACE(named.name);
    const Surface surface{named.mesh};
    test::Random random(7);
    for (int k = 0; k < 200; ++k) surface.expectClosest(test::randomVector(random, 4));
    for (int k = 0; k < 100; ++k) surface.expectClosest(test::randomVector(random, 0.4));
  }
}

TEST(ClosestPoint, OfAVertexIsThatVertex)
{
  for (const test::NamedMesh& named : test::lawMeshes()) {
    const Surface surface{named.mesh};
    for (Index v = 0; v < named.mesh.vertexCount(); ++v) {
      const ClosestPointSearch::Result found = surface.search.find(named.mesh.positions.row(v));
      EXPECT_EQ(found.point, (SurfacePoint{{{v, 1.0}}})) << named.name;
      EXPECT_EQ(found.distance, 0);
      const auto first = std::find_if(
          surface.triangles.begin(), surface.triangles.end(),
          [&](const Triangle& triangle) { return std::find(triangle.begin(), triangle.end(), v) != triangle.end(); });
      EXPECT_EQ(found.triangle, first - surface.triangles.begin()) << "of those around it the first";
    }
  }
}

TEST(ClosestPoint, OfAPointOfAnEdgeHangsOnItsTwoVertices)
{
  const Surface surface{test::grid(6, 5)};
  const ClosestPointSearch::Result onEdge = surface.search.find({2.25, 3, 0});
  ASSERT_EQ(onEdge.point.terms.size(), 2U);
  EXPECT_EQ(onEdge.point.terms[0], (Term{23, 0.75}));
  EXPECT_EQ(onEdge.point.terms[1], (Term{24, 0.25}));
  const ClosestPointSearch::Result beside = surface.search.find({2.5, -3, 4});
  EXPECT_EQ(beside.distance, 5);
  EXPECT_EQ(beside.point, (SurfacePoint{{{2, 0.5}, {3, 0.5}}}));
}

TEST(ClosestPoint, OfPointsOnTheSurfaceIsWhereTheyAre)
{
  for (const test::NamedMesh& named : test::lawMeshes()) {
    SCOPED_TRACE(named.name);
    const Surface surface{named.mesh};
    test::Random random(3);
    for (int k = 0; k < 200; ++k) {
      const Triangle& t = surface.triangles[random.integer(0, static_cast<long>(surface.triangles.size()) - 1)];
      const double a = random.uniform(0, 1);
      const double b = random.uniform(0, 1 - a) * static_cast<double>(random.integer(0, 1));
      const Vector3 place = a * named.mesh.positions.row(t[0]) + b * named.mesh.positions.row(t[1]) +
                            (1 - a - b) * named.mesh.positions.row(t[2]);
      surface.expectClosest(place);
      EXPECT_LT(surface.search.find(place).distance, 1e-14);
    }
  }
}

TEST(ClosestPoint, TakesTrianglesThatAreSegmentsOrPoints)
{
  const Vector3 a(0, 0, 0);
  const Vector3 b(2, 0, 0);
  const TrianglePoint onSegment = closestPointOfTriangle({a, b, (a + b) / 2}, {0.5, 3, 4});
  EXPECT_EQ(onSegment.position, Vector3(0.5, 0, 0));
  EXPECT_EQ(onSegment.squaredDistance, 25);
  const TrianglePoint onPoint = closestPointOfTriangle({b, b, b}, {2, 3, 4});
  EXPECT_EQ(onPoint.position, b);
  EXPECT_EQ(onPoint.squaredDistance, 25);
  EXPECT_EQ(closestPointOfTriangle({a, a, b}, {1, 1, 0}).position, Vector3(1, 0, 0));
}

TEST(ClosestPoint, OfSliversIsNoFartherThanTheirSides)
{
  for (std::uint32_t seed = 0; seed < 300; ++seed) {
    test::Random random(seed);
    const Vector3 a = test::randomVector(random, 1);
    const Vector3 b = test::randomVector(random, 1);
    const double height = std::pow(10, random.uniform(-18, -1));
    const Vector3 c = a + random.uniform(0, 1) * (b - a) + height * test::randomVector(random, 1);
    const Vector3 place = test::randomVector(random, 1);
    const TrianglePoint found = closestPointOfTriangle({a, b, c}, place);
    EXPECT_NEAR(std::sqrt(found.squaredDistance), std::sqrt(static_cast<double>(squaredDistance({a, b, c}, place))),
                1e-13);
    for (const double weight : found.weights) EXPECT_GE(weight, 0);
  }
}

TEST(ClosestPoint, DoesNotDependOnTheUnitOfLength)
{
  for (const test::NamedMesh& named : test::lawMeshes()) {
    SCOPED_TRACE(named.name);
    const Surface surface{named.mesh};
    for (const int exponent : {-800, -500, -300, 300, 500, 1010}) {
      Mesh other = named.mesh;
      other.positions = named.mesh.positions.unaryExpr([&](double x) { return std::ldexp(x, exponent); });
      const Surface scaled{other};
      test::Random random(5);
      for (int k = 0; k < 50; ++k) {
        const Vector3 place = test::randomVector(random, 3);
        const Vector3 scaledPlace = place.unaryExpr([&](double x) { return std::ldexp(x, exponent); });
        const ClosestPointSearch::Result expected = surface.search.find(place);
        const ClosestPointSearch::Result found = scaled.search.find(scaledPlace);
        EXPECT_EQ(found.point, expected.point) << exponent;
        EXPECT_EQ(found.distance, std::ldexp(expected.distance, exponent));
      }
    }
  }
}

TEST(ClosestPoint, OfAPlaceHoweverFarIsOnTheSurface)
{
  const Surface surface{test::box(Vector3(1, 1, 1), 2)};
  for (const double away : {1e20, 1e100, 1e154, 1e200, 1e307}) {
    const ClosestPointSearch::Result found = surface.search.find({away, away, away});
    EXPECT_LE((positionOf(found.point, surface.mesh.positions) - Vector3(1, 1, 1)).norm(), 2);
    EXPECT_DOUBLE_EQ(found.distance / away, std::sqrt(3.0)) << away;
    EXPECT_DOUBLE_EQ(surface.search.find({0, -away, 0}).distance, away);
  }
}

TEST(ClosestPoint, IsTheSameOnEveryRun)
{
  const Mesh mesh = test::box(Vector3(1, 1, 1), 4);
  const Surface first{mesh};
  const Surface second{mesh};
  // The middle is equally far from every side.
  EXPECT_EQ(first.search.find({0.5, 0.5, 0.5}).point, second.search.find({0.5, 0.5, 0.5}).point);
  EXPECT_EQ(first.search.find({0.5, 0.5, 0.5}).distance, 0.5);
}

}  // namespace
}  // namespace holdfast
