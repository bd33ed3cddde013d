#include <algorithm>
#include <cmath>
#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/mesh/near_pairs.h>
#include <holdfast/mesh/solver_mesh.h>
#include <holdfast/mesh/vertex_normals.h>

#include "support/law_meshes.h"
#include "support/meshes.h"
#include "support/point_constraints.h"

namespace holdfast {
namespace {

using testing::ElementsAre;

Weld weldOf(const Mesh& mesh)
{
  return weldOpenEdges(mesh.positions, triangulate(mesh).triangles);
}

bool isWelded(const Weld& weld)
{
  return weld.unknownCount < static_cast<Index>(weld.unknownOf.size());
}

TEST(Weld, ChangesNothingWhereNoVerticesCoincide)
{
  for (const test::NamedMesh& named : test::lawMeshes()) {
    const Weld weld = weldOf(named.mesh);
    EXPECT_EQ(weld.unknownCount, named.mesh.vertexCount()) << named.name;
    for (Index v = 0; v < named.mesh.vertexCount(); ++v) EXPECT_EQ(weld.unknownOf[v], v);
    EXPECT_EQ(weld.firstVertexOf, weld.unknownOf);
  }
}

TEST(Weld, MakesOneSurfaceOfFacesWithVerticesOfTheirOwn)
{
  for (const test::NamedMesh& named : test::lawMeshes()) {
    SCOPED_TRACE(named.name);
    const Mesh apart = test::soup(named.mesh);
    const std::span<const int> vertexOf = named.mesh.faces.corners();
    const Weld weld = weldOf(apart);
    ASSERT_EQ(weld.unknownCount, named.mesh.vertexCount());
    std::vector<Index> unknownOfVertex(static_cast<std::size_t>(named.mesh.vertexCount()), -1);
    for (std::size_t k = 0; k < vertexOf.size(); ++k) {
      if (unknownOfVertex[vertexOf[k]] < 0) unknownOfVertex[vertexOf[k]] = weld.unknownOf[k];
      EXPECT_EQ(weld.unknownOf[k], unknownOfVertex[vertexOf[k]]);
    }
  }
}

TEST(Weld, NumbersUnknownsByTheirFirstVertices)
{
  const Weld weld = weldOf(test::soup(test::grid(2, 1)));
  EXPECT_TRUE(std::is_sorted(weld.firstVertexOf.begin(), weld.firstVertexOf.end()));
  for (Index u = 0; u < weld.unknownCount; ++u) {
    const auto first = std::find(weld.unknownOf.begin(), weld.unknownOf.end(), u);
    EXPECT_EQ(first - weld.unknownOf.begin(), weld.firstVertexOf[u]);
  }
}

TEST(Weld, TiesTwoOpenSheetsAlongTheirCommonBorder)
{
  const Weld weld = weldOf(test::merged(test::grid(1, 2), test::moved(test::grid(1, 2), {1, 0, 0})));
  EXPECT_EQ(weld.unknownCount, 9);
  for (const auto& [left, right] : {std::pair{1, 6}, std::pair{3, 8}, std::pair{5, 10}})
    EXPECT_EQ(weld.unknownOf[left], weld.unknownOf[right]);
}

TEST(Weld, LeavesClosedPartsThatTouchApart)
{
  const Mesh box = test::box(Vector3(1, 1, 1), 2);
  EXPECT_FALSE(isWelded(weldOf(test::merged(box, test::moved(box, {1, 0, 0})))));
  EXPECT_FALSE(isWelded(weldOf(test::merged(box, box))));
}

TEST(Weld, LeavesPartsThatMeetInAPointApart)
{
  EXPECT_FALSE(isWelded(weldOf(test::merged(test::grid(1, 1), test::moved(test::grid(1, 1), {1, 1, 0})))));
}

TEST(Weld, DoesNotTieWhatOnlyNearlyCoincides)
{
  const double almost = std::nextafter(1.0, 2.0);
  EXPECT_FALSE(isWelded(weldOf(test::merged(test::grid(1, 1), test::moved(test::grid(1, 1), {almost, 0, 0})))));
}

TEST(Weld, TakesBothZerosForOnePlace)
{
  Mesh below = test::moved(test::grid(1, 1), {0, -1, 0});
  below.positions.col(2).setConstant(-0.0);
  EXPECT_EQ(weldOf(test::merged(test::grid(1, 1), below)).unknownCount, 6);
}

TEST(Weld, TiesThreeSheetsAtOneEdge)
{
  Mesh fan{Positions(9, 3), {}};
  fan.positions << 0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 1, -1, 1, 0, 0, 0, 1, 0, 0, 0, -1, -1, 0;
  for (Index f = 0; f < 3; ++f) fan.faces.add({3 * f, 3 * f + 1, 3 * f + 2});
  const Weld weld = weldOf(fan);
  EXPECT_THAT(weld.unknownOf, ElementsAre(0, 1, 2, 0, 1, 3, 1, 0, 4));
}

TEST(SolverMesh, PartsAreNumberedByTheirFirstUnknownAndLooseVerticesAreInNone)
{
  Mesh mesh = test::merged(test::tetrahedron(), test::moved(test::grid(1, 1), {9, 0, 0}));
  mesh.positions.conservativeResize(9, 3);
  mesh.positions.row(8) << 5, 5, 5;
  const SolverMesh solver = makeSolverMesh(mesh, triangulate(mesh));
  EXPECT_EQ(solver.componentCount, 2);
  EXPECT_THAT(solver.componentOf, ElementsAre(0, 0, 0, 0, 1, 1, 1, 1, -1));
  EXPECT_EQ(componentOfVertices(solver), solver.componentOf);
}

TEST(SolverMesh, HoldsNoTriangleThatNamesAnUnknownTwice)
{
  Mesh mesh = test::grid(2, 1);
  mesh.faces.add({0, 0, 1});
  const SolverMesh solver = makeSolverMesh(mesh, triangulate(mesh));
  EXPECT_EQ(solver.triangles.size(), 4U);
  EXPECT_THAT(solver.faceOf, ElementsAre(0, 1, 2, 3));
}

TEST(SolverMesh, ReportsPartsOfEveryVertexOfASoup)
{
  const Mesh mesh = test::soup(test::merged(test::tetrahedron(), test::moved(test::tetrahedron(), {9, 0, 0})));
  const SolverMesh solver = makeSolverMesh(mesh, triangulate(mesh));
  EXPECT_EQ(solver.componentCount, 2);
  const std::vector<int> parts = componentOfVertices(solver);
  for (Index v = 0; v < mesh.vertexCount(); ++v) EXPECT_EQ(parts[v], v < 12 ? 0 : 1);
}

/// Two rows of faces with a seam at x = 2, whose right side lies `gap` beside it.
Mesh seamed(double gap)
{
  Mesh right = test::moved(test::grid(2, 2), {2 + gap, 0, 0});
  return test::merged(test::grid(2, 2), right);
}

Weld weldWithin(const Mesh& mesh, double tolerance)
{
  return weldOpenEdges(mesh.positions, triangulate(mesh).triangles, tolerance);
}

TEST(Weld, ToleranceClosesSeamsThatAreNoWider)
{
  for (const double gap : {1e-9, 1e-3, 0.1}) {
    EXPECT_FALSE(isWelded(weldOf(seamed(gap))));
    EXPECT_FALSE(isWelded(weldWithin(seamed(gap), 0.9 * gap)));
    const Weld weld = weldWithin(seamed(gap), 1.1 * gap);
    EXPECT_EQ(weld.unknownCount, 15) << "three of 18 vertices are joined";
    EXPECT_TRUE(weld.joinsApart);
  }
  const Weld exact = weldWithin(seamed(0), 1e-6);
  EXPECT_EQ(exact.unknownOf, weldOf(seamed(0)).unknownOf);
  EXPECT_FALSE(exact.joinsApart);
}

TEST(Weld, ToleranceMendsCornersThatAreOffByRounding)
{
  Mesh apart = test::soup(test::icosphere(2));
  const Index joined = weldOf(apart).unknownCount;
  for (Index v = 0; v < apart.vertexCount(); v += 97) apart.positions(v, 1) *= 1 + 1e-7;
  EXPECT_GT(weldOf(apart).unknownCount, joined);
  EXPECT_EQ(weldWithin(apart, 1e-6).unknownCount, joined);
}

TEST(Weld, ToleranceJoinsOpenEdgesAlone)
{
  const Mesh cubes =
      test::merged(test::box(Vector3(1, 1, 1), 1), test::moved(test::box(Vector3(1, 1, 1), 1), {1 + 1e-9, 0, 0}));
  EXPECT_FALSE(isWelded(weldWithin(cubes, 1e-6))) << "closed parts that merely touch";
  EXPECT_FALSE(isWelded(weldWithin(test::grid(3, 3), 0.5))) << "no two ends are that near";
}

TEST(NearPairs, AreThoseThatTryingAllPairsFinds)
{
  test::Random random(77);
  Positions positions(200, 3);
  for (Index v = 0; v < positions.rows(); ++v) positions.row(v) = test::randomVector(random, 1);
  std::vector<int> vertices(200);
  std::iota(vertices.begin(), vertices.end(), 0);
  for (const double distance : {1e-12, 0.1, 0.3, 5.0}) {
    std::vector<std::array<int, 2>> expected;
    for (int a = 0; a < 200; ++a)
      for (int b = a + 1; b < 200; ++b)
        if ((positions.row(a) - positions.row(b)).norm() <= distance) expected.push_back({a, b});
    EXPECT_EQ(nearPairs(positions, vertices, distance), expected) << distance;
  }
}

}  // namespace
}  // namespace holdfast
