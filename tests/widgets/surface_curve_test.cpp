#include <gtest/gtest.h>

#include <holdfast/surface/curve_region.h>
#include <holdfast/widgets/marks/surface_curve.h>

#include "support/law_meshes.h"
#include "support/meshes.h"

namespace holdfast {
namespace {

Positions through(const Mesh& mesh, const std::vector<Index>& vertices, const Positions& positions)
{
  const SolverMesh solverMesh = makeSolverMesh(mesh, triangulate(mesh));
  return curveThrough(vertices, EdgeGraph(solverMesh), solverMesh, positions);
}

TEST(SurfaceCurve, ClosesThroughThePresentPlacesOfTheCurve)
{
  const Mesh mesh = test::icosphere(2);
  const Positions moved = 3 * mesh.positions;
  const std::vector<Index> places{3, 50, 120};
  const std::vector<Index> curve = closedCurve(EdgeGraph(makeSolverMesh(mesh, triangulate(mesh))), places);
  const Positions line = through(mesh, places, moved);
  ASSERT_EQ(line.rows(), static_cast<Index>(curve.size()) + 1);
  for (std::size_t k = 0; k < curve.size(); ++k) EXPECT_EQ(line.row(static_cast<Index>(k)), moved.row(curve[k]));
  EXPECT_EQ(line.row(line.rows() - 1), line.row(0));
}

TEST(SurfaceCurve, LeadsAcrossFacesThatShareNoVertices)
{
  const Mesh mesh = test::soup(test::quadBox({1, 1, 1}, 4));
  const Positions line = through(mesh, {0, 100, 300}, mesh.positions);
  ASSERT_GT(line.rows(), 4);
  for (Index k = 0; k + 1 < line.rows(); ++k) EXPECT_LT((line.row(k) - line.row(k + 1)).norm(), 0.36);
}

TEST(SurfaceCurve, OfOneVertexIsItsPlace)
{
  const Mesh mesh = test::tetrahedron();
  const Positions line = through(mesh, {2, 2}, mesh.positions);
  ASSERT_EQ(line.rows(), 2);
  EXPECT_EQ(line.row(0), mesh.positions.row(2));
  EXPECT_EQ(line.row(1), mesh.positions.row(2));
}

TEST(SurfaceCurve, IsEmptyWhereNoEdgesJoinThePlaces)
{
  const Mesh mesh = test::withVertex(test::merged(test::tetrahedron(), test::tetrahedron()), {9, 9, 9});
  EXPECT_EQ(through(mesh, {}, mesh.positions).rows(), 0);
  EXPECT_EQ(through(mesh, {0, 1, 5}, mesh.positions).rows(), 0);
  EXPECT_EQ(through(mesh, {8}, mesh.positions).rows(), 0);
}

}  // namespace
}  // namespace holdfast
