#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/surface/vertex_regions.h>

#include "support/law_meshes.h"
#include "support/meshes.h"

namespace holdfast {
namespace {

using testing::ElementsAre;

std::vector<Index> around(const Mesh& mesh, Index face, double degrees, BendFrom from = BendFrom::Neighbour)
{
  const SolverMesh solverMesh = makeSolverMesh(mesh, triangulate(mesh));
  return SmoothFaces(mesh, solverMesh).around(face, degrees, from);
}

double flatShareOf(const Mesh& mesh)
{
  const SolverMesh solverMesh = makeSolverMesh(mesh, triangulate(mesh));
  return SmoothFaces(mesh, solverMesh).flatShare();
}

Vector3 normalOf(const Mesh& mesh, Index face)
{
  const auto corner = [&](int k) { return Vector3(mesh.positions.row(mesh.faces[face][k])); };
  return (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
}

/// A box that no axis is along.
Mesh tilted(const Mesh& mesh)
{
  return test::transformed(mesh, Eigen::Affine3d(Eigen::AngleAxisd(0.7, Vector3(1, 2, 3).normalized())));
}

TEST(SmoothFaces, SidesOfABoxAreFoundWithOneFace)
{
  constexpr Index kDivisions = 4;
  for (const Mesh& mesh : {tilted(test::box({1, 2, 3}, kDivisions)), tilted(test::quadBox({1, 2, 3}, kDivisions)),
                           test::soup(test::quadBox({1, 2, 3}, kDivisions))})
    for (const double degrees : {0.0, 42.0, 89.0}) {
      const Index side = mesh.faces.size() / 6;
      for (const Index face : {Index{0}, side + 3, mesh.faces.size() - 1})
        EXPECT_EQ(static_cast<Index>(around(mesh, face, degrees).size()), side) << face << ", " << degrees;
    }
}

TEST(SmoothFaces, AnglesUpToTheGivenOneCount)
{
  const Mesh mesh = test::box({1, 2, 3}, 2);
  EXPECT_EQ(static_cast<Index>(around(mesh, 0, 90).size()), mesh.faces.size()) << "90 degrees exactly";
  EXPECT_EQ(static_cast<Index>(around(mesh, 0, 89.99).size()), mesh.faces.size() / 6);
}

TEST(SmoothFaces, BendsAddUpAlongTheWay)
{
  const Mesh mesh = test::icosphere(3);
  EXPECT_EQ(static_cast<Index>(around(mesh, 5, 20).size()), mesh.faces.size());
  EXPECT_THAT(around(mesh, 5, 0.1), ElementsAre(5));
}

TEST(SmoothFaces, FromTheFirstFaceOnlyWhatLooksAsItDoesIsReached)
{
  const Mesh mesh = test::icosphere(3);
  for (const double degrees : {5.0, 20.0, 60.0, 120.0}) {
    std::vector<Index> cap;
    for (Index f = 0; f < mesh.faces.size(); ++f)
      if (normalOf(mesh, f).dot(normalOf(mesh, 5)) >= std::cos(degrees * std::numbers::pi / 180)) cap.push_back(f);
    EXPECT_EQ(around(mesh, 5, degrees, BendFrom::FirstFace), cap) << degrees;
  }
  EXPECT_EQ(static_cast<Index>(around(mesh, 5, 180, BendFrom::FirstFace).size()), mesh.faces.size());
}

TEST(SmoothFaces, FromTheFirstFaceSidesAreComparedAsIfTheyAgreed)
{
  Mesh mesh{test::icosphere(2).positions, {}};
  const Mesh whole = test::icosphere(2);
  // Every third face has its other side out.
  for (Index f = 0; f < whole.faces.size(); ++f) {
    const auto& corners = whole.faces[f];
    if (f % 3 == 0)
      mesh.faces.add({corners[0], corners[2], corners[1]});
    else
      mesh.faces.add({corners[0], corners[1], corners[2]});
  }
  EXPECT_EQ(around(mesh, 5, 40, BendFrom::FirstFace), around(whole, 5, 40, BendFrom::FirstFace));
}

TEST(SmoothFaces, TheFlatShareIsThatOfEdgesWithinPlanes)
{
  EXPECT_EQ(flatShareOf(test::grid(3, 3)), 1);
  EXPECT_EQ(flatShareOf(test::icosphere(2)), 0);
  // A cube of squares cut in two: 6 diagonals lie in its planes, 12 edges bend.
  EXPECT_NEAR(flatShareOf(tilted(test::box({1, 2, 3}, 1))), 6.0 / 18, 1e-15);
  EXPECT_EQ(flatShareOf(Mesh{}), 0);
}

TEST(SmoothFaces, OtherPartsAreNotReached)
{
  const Mesh mesh = test::merged(test::grid(2, 2), test::moved(test::grid(2, 2), {5, 0, 0}));
  EXPECT_THAT(around(mesh, 8, 180), ElementsAre(8, 9, 10, 11, 12, 13, 14, 15));
}

TEST(SmoothFaces, FacesThatDisagreeOnTheOutsideAreComparedAsIfTheyAgreed)
{
  Mesh mesh{test::grid(1, 1).positions, {}};
  mesh.faces.add({0, 1, 3});
  mesh.faces.add({0, 2, 3});
  EXPECT_THAT(around(mesh, 0, 0), ElementsAre(0, 1));
  mesh.positions(2, 2) = 1;
  EXPECT_THAT(around(mesh, 0, 30), ElementsAre(0));
  EXPECT_THAT(around(mesh, 0, 90), ElementsAre(0, 1));
}

TEST(SmoothFaces, FacesWithoutAnAreaBendAsThoseBeforeThem)
{
  // Two squares, joined by a needle along x = 1 whose middle vertex only one of them has.
  Mesh mesh{Positions(7, 3), {}};
  mesh.positions << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 1, 0.5, 0, 2, 0, 0, 2, 1, 0;
  mesh.faces.add({0, 1, 2, 3});
  mesh.faces.add({1, 4, 2});
  mesh.faces.add({1, 5, 6, 2, 4});
  EXPECT_THAT(around(mesh, 0, 0), ElementsAre(0, 1, 2));
  mesh.positions.bottomRows(2).col(2).setConstant(1);
  EXPECT_THAT(around(mesh, 0, 10), ElementsAre(0, 1)) << "a needle does not lead around a corner";
  EXPECT_THAT(around(mesh, 0, 45), ElementsAre(0, 1, 2));
}

TEST(SmoothFaces, EdgesOfThreeFacesAreNotCrossed)
{
  Mesh mesh{Positions(5, 3), {}};
  mesh.positions << 0, 0, 0, 0, 1, 0, 1, 0, 0, -1, 0, 0, 0, 0, 1;
  mesh.faces.add({0, 2, 1});
  mesh.faces.add({0, 1, 3});
  EXPECT_THAT(around(mesh, 0, 0), ElementsAre(0, 1));
  mesh.faces.add({0, 1, 4});
  EXPECT_THAT(around(mesh, 0, 180), ElementsAre(0));
}

}  // namespace
}  // namespace holdfast
