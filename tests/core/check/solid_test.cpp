#include <span>
#include <vector>

#include <gtest/gtest.h>

#include <holdfast/check/mesh_check.h>

#include "support/law_meshes.h"
#include "support/meshes.h"

namespace holdfast {
namespace {

bool isSolidMesh(const Mesh& mesh)
{
  return isSolid(test::solverMeshOf(mesh));
}

std::vector<Index> turnedRound(std::span<const int> face)
{
  return {face.rbegin(), face.rend()};
}

/// The same with every face turned round.
Mesh insideOut(const Mesh& mesh)
{
  Mesh rotated;
  rotated.positions = mesh.positions;
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    rotated.faces.add(turnedRound(mesh.faces[f]));
  }
  return rotated;
}

Mesh withoutFace(const Mesh& mesh, Index face)
{
  Mesh open;
  open.positions = mesh.positions;
  for (Index f = 0; f < mesh.faces.size(); ++f)
    if (f != face) open.faces.add(mesh.faces[f]);
  return open;
}

TEST(Solid, AreClosedMeshesWithTheirFrontsOutside)
{
  EXPECT_TRUE(isSolidMesh(test::tetrahedron()));
  EXPECT_TRUE(isSolidMesh(test::icosphere(2)));
  EXPECT_TRUE(isSolidMesh(test::quadBox({1, 2, 3}, 3)));
  EXPECT_TRUE(isSolidMesh(test::soup(test::icosphere(1)))) << "what is welded is closed";
  EXPECT_TRUE(isSolidMesh(test::merged(test::icosphere(1), test::moved(test::icosphere(1), {3, 0, 0}))));
}

TEST(Solid, FarFromTheOriginAndOfAnySize)
{
  EXPECT_TRUE(isSolidMesh(test::moved(test::icosphere(1), {1e6, -1e6, 1e6})));
  for (const double size : {1e-200, 1e200}) {
    Mesh mesh = test::icosphere(1);
    mesh.positions *= size;
    EXPECT_TRUE(isSolidMesh(mesh)) << size;
  }
}

TEST(Solid, AreNotThoseWithAHoleOrABackOutside)
{
  EXPECT_FALSE(isSolidMesh(test::plate(3, 3)));
  EXPECT_FALSE(isSolidMesh(withoutFace(test::icosphere(2), 7)));
  EXPECT_FALSE(isSolidMesh(insideOut(test::icosphere(2))));
  EXPECT_FALSE(isSolidMesh(test::merged(test::icosphere(1), insideOut(test::moved(test::tetrahedron(), {9, 0, 0})))));
}

TEST(Solid, AreNotThoseWhoseTrianglesDisagree)
{
  Mesh mesh = withoutFace(test::icosphere(1), 3);
  const Mesh all = test::icosphere(1);
  mesh.faces.add(turnedRound(all.faces[3]));
  EXPECT_FALSE(isSolidMesh(mesh));
  EXPECT_FALSE(isSolidMesh(test::withFace(all, {0, 1, 2}))) << "an edge of three triangles";
}

}  // namespace
}  // namespace holdfast
