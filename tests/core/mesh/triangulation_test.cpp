#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <holdfast/mesh/triangulation.h>
#include <holdfast/mesh/vertex_normals.h>

#include "support/law_meshes.h"
#include "support/meshes.h"
#include "support/random.h"

namespace holdfast {
namespace {

/// One face whose corners are `points` in order.
Mesh polygon(const std::vector<Vector3>& points)
{
  Mesh mesh{Positions(static_cast<Index>(points.size()), 3), {}};
  std::vector<Index> corners(points.size());
  std::iota(corners.begin(), corners.end(), Index{0});
  for (const Index v : corners) mesh.positions.row(v) = points[v];
  mesh.faces.add(corners);
  return mesh;
}

Vector3 areaVectorOf(const Mesh& mesh, const Triangle& triangle)
{
  const Vector3 a = mesh.positions.row(triangle[0]);
  return (Vector3(mesh.positions.row(triangle[1])) - a).cross(Vector3(mesh.positions.row(triangle[2])) - a) / 2;
}

/// A polygon whose corners are seen from the origin in ascending angles, at distances that jump: simple, and concave
/// nearly always.
std::vector<Vector3> star(test::Random& random, int corners)
{
  std::vector<Vector3> points;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * std::numbers::pi * (k + random.uniform(0, 0.8)) / corners;
    const double radius = random.uniform(0.2, 1);
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
  }
  return points;
}

/// The number of triangles that hold the place (x, y), all of them in the plane z = 0.
int coverOf(const Mesh& mesh, const Triangulation& triangulation, const Vector3& place)
{
  return static_cast<int>(
      std::count_if(triangulation.triangles.begin(), triangulation.triangles.end(), [&](const Triangle& triangle) {
        for (int k = 0; k < 3; ++k) {
          const Vector3 from = mesh.positions.row(triangle[k]);
          const Vector3 to = mesh.positions.row(triangle[(k + 1) % 3]);
          if ((to - from).cross(place - from).z() < 0) return false;
        }
        return true;
      }));
}

TEST(Triangulate, GivesTwoTrianglesLessThanCornersAndNamesTheirFaceAndCorners)
{
  for (const test::NamedMesh& named : test::lawMeshes()) {
    SCOPED_TRACE(named.name);
    const Triangulation result = triangulate(named.mesh);
    std::vector<Index> count(named.mesh.faces.size(), 0);
    for (std::size_t t = 0; t < result.triangles.size(); ++t) {
      ++count[result.faceOf[t]];
      for (int k = 0; k < 3; ++k)
        EXPECT_EQ(named.mesh.faces[result.faceOf[t]][result.cornersOf(t)[k]], result.triangles[t][k]);
    }
    for (Index f = 0; f < named.mesh.faces.size(); ++f)
      EXPECT_EQ(count[f], static_cast<Index>(named.mesh.faces[f].size()) - 2) << "face " << f;
    EXPECT_TRUE(std::is_sorted(result.faceOf.begin(), result.faceOf.end()));
  }
}

TEST(Triangulate, KeepsCornersOnlyWhereAFaceHasMoreThanThree)
{
  const Triangulation ofTriangles = triangulate(test::icosphere(1));
  EXPECT_TRUE(ofTriangles.corners.empty());
  EXPECT_EQ(ofTriangles.cornersOf(7), (std::array<Index, 3>{0, 1, 2}));
  Mesh mixed = test::grid(2, 2);
  mixed.faces.add({0, 1, 2, 3});
  EXPECT_EQ(triangulate(mixed).corners.size(), triangulate(mixed).triangles.size());
}

TEST(Triangulate, LeavesTrianglesAsTheyAre)
{
  const Mesh mesh = test::icosphere(1);
  const Triangulation result = triangulate(mesh);
  for (Index f = 0; f < mesh.faces.size(); ++f)
    EXPECT_TRUE(std::equal(mesh.faces[f].begin(), mesh.faces[f].end(), result.triangles[f].begin()));
}

TEST(Triangulate, CoversConcavePolygonsOnceWithTheSideOfTheFaceUp)
{
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    test::Random random(seed);
    const Mesh mesh = polygon(star(random, static_cast<int>(random.integer(4, 15))));
    const Triangulation result = triangulate(mesh);
    double sum = 0;
    for (const Triangle& triangle : result.triangles) {
      EXPECT_GE(areaVectorOf(mesh, triangle).z(), 0);
      sum += areaVectorOf(mesh, triangle).norm();
    }
    EXPECT_NEAR(sum, areaVector(mesh.positions, mesh.faces[0]).norm(), 1e-14);
    for (int k = 0; k < 20; ++k) EXPECT_LE(coverOf(mesh, result, {random.uniform(-1, 1), random.uniform(-1, 1), 0}), 1);
  }
}

TEST(Triangulate, CoversPolygonsOfManyCornersOnce)
{
  for (const int corners : {31, 32, 33, 64, 65, 1000, 5000}) {
    SCOPED_TRACE(corners);
    test::Random random(static_cast<std::uint32_t>(corners));
    const Mesh mesh = polygon(star(random, corners));
    double sum = 0;
    for (const Triangle& triangle : triangulate(mesh).triangles) {
      EXPECT_GE(areaVectorOf(mesh, triangle).z(), 0);
      sum += areaVectorOf(mesh, triangle).norm();
    }
    EXPECT_NEAR(sum, areaVector(mesh.positions, mesh.faces[0]).norm(), 1e-12);
  }
}

/// A wavy disc without corners of note.
std::vector<Vector3> wavyDisc(int corners)
{
  std::vector<Vector3> points;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * std::numbers::pi * k / corners;
    const double radius = 1 + 0.3 * std::sin(7 * angle);
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.1 * std::sin(angle));
  }
  return points;
}

/// In less than a second. Work that grows with the square of the corners would go on for a quarter of an hour, and the
/// test would be ended before.
TEST(Triangulate, EndsForAPolygonOfVeryManyCorners)
{
  constexpr int kCorners = 200'000;
  EXPECT_EQ(triangulate(polygon(wavyDisc(kCorners))).triangles.size(), kCorners - 2);
}

TEST(Triangulate, DoesNotDependOnTheFirstCornerOfAQuadrilateral)
{
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    test::Random random(seed);
    std::vector<Vector3> points = star(random, 4);
    const Triangulation first = triangulate(polygon(points));
    std::rotate(points.begin(), points.begin() + 1, points.end());
    const Triangulation second = triangulate(polygon(points));
    const auto hasCorner = [](const Triangulation& result, Index v) {
      return std::all_of(result.triangles.begin(), result.triangles.end(),
                         [&](const Triangle& t) { return std::find(t.begin(), t.end(), v) != t.end(); });
    };
    for (Index v = 0; v < 4; ++v) EXPECT_EQ(hasCorner(first, v), hasCorner(second, (v + 3) % 4));
  }
}

TEST(Triangulate, SplitsAQuadrilateralWhereNoNeedleComesOfIt)
{
  // A thin rhombus: its short diagonal joins the corners 1 and 3.
  const Triangulation rhombus = triangulate(polygon({{-4, 0, 0}, {0, -1, 0}, {4, 0, 0}, {0, 1, 0}}));
  for (const Triangle& triangle : rhombus.triangles) {
    EXPECT_EQ(std::count(triangle.begin(), triangle.end(), 1), 1);
    EXPECT_EQ(std::count(triangle.begin(), triangle.end(), 3), 1);
  }
  // An arrow head: only the diagonal from the dent to the tip lies inside.
  const Triangulation arrow = triangulate(polygon({{0, 0, 0}, {-2, -1, 0}, {3, 0, 0}, {-2, 1, 0}}));
  for (const Triangle& triangle : arrow.triangles) {
    EXPECT_EQ(std::count(triangle.begin(), triangle.end(), 0), 1);
    EXPECT_EQ(std::count(triangle.begin(), triangle.end(), 2), 1);
  }
}

TEST(Triangulate, DoesNotCutThroughACornerWhereItCanCutElsewhere)
{
  // An L of three squares with a corner at every lattice point: three of its diagonals pass through the inner one.
  std::vector<Vector3> points{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}, {0, 1, 0}};
  for (std::size_t first = 0; first < points.size(); ++first) {
    const Mesh mesh = polygon(points);
    for (const Triangle& triangle : triangulate(mesh).triangles)
      EXPECT_GE(areaVectorOf(mesh, triangle).z(), 0.5) << first;
    std::rotate(points.begin(), points.begin() + 1, points.end());
  }
}

TEST(Triangulate, TakesDegeneratePolygonsWithoutComplaint)
{
  const Vector3 p(1, 2, 3);
  const Vector3 q(2, 2, 3);
  for (const Mesh& mesh :
       {polygon({p, p, p, p, p}), polygon({p, q, p, q}), polygon({p, q, q, q, p, p}),
        polygon({p, 2 * p, 3 * p, 4 * p, 5 * p}), polygon({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}})})
    EXPECT_EQ(triangulate(mesh).triangles.size(), mesh.faces[0].size() - 2);
  Mesh repeated = polygon({p, q, 3 * p, 2 * q});
  repeated.faces = {};
  repeated.faces.add({0, 1, 1, 2, 0});
  EXPECT_EQ(triangulate(repeated).triangles.size(), 3U);
}

}  // namespace
}  // namespace holdfast
