#include <array>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/mesh/vertex_normals.h>

#include "support/meshes.h"
#include "support/one_core.h"

namespace holdfast {
namespace {

TEST(VertexNormals, AreaVectorsOfAClosedMeshSumToZero)
{
  const Mesh mesh = test::box(Vector3(1, 2, 3), 4);
  Vector3 sum = Vector3::Zero();
  double area = 0;
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    sum += areaVector(mesh.positions, mesh.faces[f]);
    area += areaVector(mesh.positions, mesh.faces[f]).norm();
  }
  EXPECT_LT(sum.norm(), 1e-13);
  EXPECT_NEAR(area, 22, 1e-12);
}

TEST(VertexNormals, AreaOfAPolygonIsThatOfItsTriangles)
{
  Positions positions(5, 3);
  positions << 0, 0, 7, 2, 0, 7, 1, 1, 7, 2, 2, 7, 0, 2, 7;  // a dent at (1, 1)
  EXPECT_EQ(areaVector(positions, std::array{0, 1, 2, 3, 4}), Vector3(0, 0, 3));
}

TEST(VertexNormals, OfASpherePointOutwards)
{
  const Mesh mesh = test::icosphere(3);
  const Positions normals = areaWeightedNormals(mesh.positions, mesh.faces, mesh.faces.corners(), mesh.vertexCount());
  for (Index v = 0; v < mesh.vertexCount(); ++v) EXPECT_GT(normals.row(v).dot(mesh.positions.row(v)), 0.999);
}

TEST(VertexNormals, AreWeightedByArea)
{
  Positions positions(4, 3);
  positions << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 3;
  Polygons faces;
  faces.add({0, 1, 2});  // half a unit of area towards z
  faces.add({0, 2, 3});  // three halves towards x
  const Positions normals = areaWeightedNormals(positions, faces, faces.corners(), 4);
  EXPECT_LT((normals.row(0) - Eigen::RowVector3d(3, 0, 1).normalized()).norm(), 1e-15);
}

TEST(VertexNormals, NeitherTinyNorHugeMeshesLoseThem)
{
  const Mesh mesh = test::tetrahedron();
  const auto normalsAt = [&](double scale) {
    return areaWeightedNormals(mesh.positions * scale, mesh.faces, mesh.faces.corners(), 4);
  };
  EXPECT_TRUE(normalsAt(1e-140).isApprox(normalsAt(1), 1e-14));
  EXPECT_TRUE(normalsAt(1e140).isApprox(normalsAt(1), 1e-14));
}

TEST(VertexNormals, FollowPositionsWithTheSameBitsOnOneCore)
{
  const Mesh mesh = test::icosphere(5);  // 20,480 faces: several blocks of a loop over threads
  std::vector<int> normalOfCorner(mesh.faces.corners().begin(), mesh.faces.corners().end());
  for (std::size_t corner = 0; corner < normalOfCorner.size(); corner += 7) normalOfCorner[corner] = -1;
  AreaWeightedNormals normals(mesh.faces, normalOfCorner, mesh.vertexCount());
  normals.at(mesh.positions);
  const Positions moved = mesh.positions.array().cube();
  const Positions onAll = normals.at(moved);

  Positions sums = Positions::Zero(mesh.vertexCount(), 3);
  std::size_t corner = 0;
  for (Index f = 0; f < mesh.faces.size(); ++f)
    for (std::size_t k = 0; k < mesh.faces[f].size(); ++k, ++corner)
      if (normalOfCorner[corner] >= 0) sums.row(normalOfCorner[corner]) += areaVector(moved, mesh.faces[f]);
  for (Index n = 0; n < sums.rows(); ++n) ASSERT_EQ(Vector3(onAll.row(n)), unitOrZero(sums.row(n))) << n;
  const test::OneCore one;
  EXPECT_EQ(normals.at(moved), onAll);
}

TEST(VertexNormals, AreZeroWhereNothingDefinesThem)
{
  EXPECT_EQ(unitOrZero(Vector3::Zero()), Vector3::Zero());
  EXPECT_EQ(unitOrZero(Vector3(1, std::nan(""), 0)), Vector3::Zero());
  EXPECT_EQ(unitOrZero(Vector3(std::numeric_limits<double>::infinity(), 0, 0)), Vector3::Zero());
  const Mesh mesh = test::tetrahedron();
  const std::vector<int> none(mesh.faces.cornerCount(), -1);
  EXPECT_EQ(areaWeightedNormals(mesh.positions, mesh.faces, none, 2), Positions::Zero(2, 3));
}

}  // namespace
}  // namespace holdfast
