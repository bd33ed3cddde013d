#include <cmath>
#include <functional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/geometry/rotation_log.h>
#include <holdfast/verdict/crossing_faces.h>
#include <holdfast/verdict/shape_change.h>

#include "support/law_meshes.h"
#include "support/meshes.h"
#include "support/point_constraints.h"
#include "support/random.h"

namespace holdfast {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A mesh with its surface at rest, to be looked at in other positions.
class RestingMesh {
 public:
  explicit RestingMesh(const Mesh& mesh) : mesh_(mesh), solverMesh_(test::solverMeshOf(mesh)), rest_(solverMesh_) {}

  [[nodiscard]] ShapeChange changeAt(const Positions& now) const
  {
    return changeOf({solverMesh_, rest_, mesh_.positions, now});
  }
  [[nodiscard]] std::vector<Index> invertedAt(const Positions& now) const
  {
    return facesOf(solverMesh_, invertedTriangles(rest_, changeAt(now).foldedHinges));
  }
  [[nodiscard]] CrossingTriangles crossingTrianglesAt(const Positions& now) const
  {
    return CrossingSearch(rest_, mesh_.positions).find(now);
  }
  [[nodiscard]] std::vector<Index> crossingAt(const Positions& now) const
  {
    return facesOf(solverMesh_, crossingTrianglesAt(now).triangles);
  }
  [[nodiscard]] Positions movedBy(const std::function<Vector3(const Vector3&)>& motion) const
  {
    Positions now = mesh_.positions;
    for (Index v = 0; v < now.rows(); ++v) now.row(v) = motion(now.row(v));
    return now;
  }
  [[nodiscard]] Positions withVertexAt(Index vertex, const Vector3& place) const
  {
    Positions now = mesh_.positions;
    now.row(vertex) = place;
    return now;
  }

 private:
  Mesh mesh_;
  SolverMesh solverMesh_;
  RestSurface rest_;
};

void expectNothing(const ShapeChange& change)
{
  EXPECT_THAT(change.foldedHinges, IsEmpty());
  for (const Ratios* ratios : {&change.lengths, &change.areas, &change.volumes}) {
    EXPECT_NEAR(ratios->least, 1, 1e-5);
    EXPECT_NEAR(ratios->most, 1, 1e-5);
    EXPECT_EQ(ratios->shrunkCount + ratios->grownCount, 0);
  }
}

TEST(ShapeChange, ARigidMotionIsNone)
{
  const Eigen::Matrix3d R = rotationMatrix(Vector3(1, 2, 3), 200);
  for (const test::NamedMesh& named : test::lawMeshes()) {
    SCOPED_TRACE(named.name);
    const RestingMesh mesh(named.mesh);
    const Positions now = mesh.movedBy([&](const Vector3& p) -> Vector3 { return R * p + Vector3(5, -70, 11); });
    expectNothing(mesh.changeAt(now));
    EXPECT_THAT(mesh.crossingAt(now), IsEmpty());
  }
}

/// A bar along z, of squares of 0.2.
RestingMesh bar()
{
  return RestingMesh(
      test::transformed(test::box(Vector3(1, 1, 1), 20), Eigen::Affine3d(Eigen::Scaling(1.0, 1.0, 8.0))));
}

TEST(ShapeChange, OfASurfaceThatIsCrumpledAllOverAPartIsSearched)
{
  const RestingMesh plate(test::plate(60, 60));
  const auto asItIs = [](const Vector3& place) { return place; };
  EXPECT_TRUE(plate.crossingTrianglesAt(plate.movedBy(asItIs)).areAll);
  test::Random random(1);
  const auto anywhere = [&](const Vector3& /*place*/) { return test::randomVector(random, 30); };
  const CrossingTriangles crossing = plate.crossingTrianglesAt(plate.movedBy(anywhere));
  EXPECT_FALSE(crossing.areAll);
  EXPECT_GT(crossing.triangles.size(), 100U);
}

TEST(ShapeChange, TwoWholeTurnsFoldNothing)
{
  const RestingMesh mesh = bar();
  const Positions now =
      mesh.movedBy([](const Vector3& p) -> Vector3 { return rotationMatrix(Vector3::UnitZ(), 720 * p.z() / 8) * p; });
  EXPECT_THAT(mesh.changeAt(now).foldedHinges, IsEmpty());
  EXPECT_THAT(mesh.invertedAt(now), IsEmpty());
  EXPECT_THAT(mesh.crossingAt(now), IsEmpty());
}

TEST(ShapeChange, ABendByAHalfTurnFoldsNothing)
{
  const RestingMesh mesh = bar();
  const Positions now = mesh.movedBy([](const Vector3& p) -> Vector3 {
    const double angle = p.z() / 8 * 3.1;
    const double radius = 8 / 3.1 + p.x();
    return {radius * std::cos(angle), p.y(), radius * std::sin(angle)};
  });
  EXPECT_THAT(mesh.changeAt(now).foldedHinges, IsEmpty());
  EXPECT_THAT(mesh.crossingAt(now), IsEmpty());
}

TEST(ShapeChange, AVertexPulledOverItsNeighboursInvertsTheFacesBehindIt)
{
  const RestingMesh mesh(test::grid(4, 4));
  // Vertex 12 is the middle, vertex 13 the next one along x.
  const Positions now = mesh.withVertexAt(12, Vector3(3.5, 2.2, 0));
  const ShapeChange change = mesh.changeAt(now);
  EXPECT_NEAR(change.foldDegrees, 180, 1e-9);
  const std::vector<Index> inverted = mesh.invertedAt(now);
  ASSERT_FALSE(inverted.empty());
  const Mesh grid = test::grid(4, 4);
  for (Index face = 0; face < grid.faces.size(); ++face) {
    const auto corners = grid.faces[face];
    const Vector3 a = now.row(corners[0]);
    const Vector3 normal = (Vector3(now.row(corners[1])) - a).cross(Vector3(now.row(corners[2])) - a);
    EXPECT_EQ(std::ranges::binary_search(inverted, face), normal.z() < 0) << "face " << face;
  }
}

TEST(ShapeChange, InversionIsSeenWhateverTheRotation)
{
  const RestingMesh mesh(test::grid(4, 4));
  const Positions flat = mesh.withVertexAt(12, Vector3(3.5, 2.2, 0));
  const Positions rotatedSheet = flat * rotationMatrix(Vector3(3, -1, 2), 170).transpose();
  EXPECT_EQ(mesh.invertedAt(rotatedSheet), mesh.invertedAt(flat));
}

TEST(ShapeChange, AnEdgeThatIsBentTheOtherWayIsAFold)
{
  const RestingMesh mesh(test::box(Vector3(1, 1, 1), 2));
  EXPECT_THAT(mesh.changeAt(mesh.movedBy([](const Vector3& p) -> Vector3 { return -p; })).foldedHinges,
              testing::Not(IsEmpty()))
      << "a mirrored box has every edge bent the other way";
}

TEST(ShapeChange, FacesThatDisagreeOnTheOutsideAreComparedAllTheSame)
{
  Mesh mesh;
  mesh.positions = test::grid(1, 1).positions;
  mesh.faces.add({0, 1, 3});
  mesh.faces.add({0, 2, 3});  // the other way round than its neighbour
  const RestingMesh resting(mesh);
  expectNothing(resting.changeAt(mesh.positions));
  EXPECT_NEAR(resting.changeAt(resting.withVertexAt(2, Vector3(1, 0.1, 0))).foldDegrees, 180, 1e-9);
}

TEST(ShapeChange, LengthsAndAreasNameWhatIsBeyondTheirLimits)
{
  const RestingMesh mesh(test::grid(1, 1));
  const ShapeChange change = mesh.changeAt(mesh.movedBy([](const Vector3& p) -> Vector3 {
    return {10 * p.x(), p.y(), 0};
  }));
  EXPECT_NEAR(change.lengths.most, 10, 1e-5);
  EXPECT_EQ(change.lengths.grownCount, 3) << "two sides along x, and the diagonal";
  EXPECT_THAT(change.lengths.grown, ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(change.areas.grown, ElementsAre(0, 1));
  EXPECT_NEAR(change.areas.most, 10, 1e-5);
}

TEST(ShapeChange, WhatIsTooSmallToBeSeenIsNotNamed)
{
  const Mesh grid = test::grid(1, 1);
  const RestingMesh mesh(test::merged(
      grid,
      test::transformed(test::grid(1, 1), Eigen::Affine3d(Eigen::Translation3d(9, 0, 0) * Eigen::Scaling(1e-4)))));
  Positions now =
      test::merged(grid, test::transformed(grid, Eigen::Affine3d(Eigen::Translation3d(9, 0, 0) * Eigen::Scaling(1e-3))))
          .positions;
  const ShapeChange change = mesh.changeAt(now);
  EXPECT_NEAR(change.lengths.most, 10, 1e-4);
  EXPECT_EQ(change.lengths.grownCount, 0);
}

TEST(ShapeChange, VolumesAreOfEachClosedPart)
{
  const Mesh ball = test::icosphere(1);
  const Mesh both = test::merged(ball, test::moved(ball, Vector3(5, 0, 0)));
  const RestingMesh mesh(both);
  Positions now = both.positions;
  for (Index v = ball.vertexCount(); v < now.rows(); ++v) now.row(v).x() = 5 + 0.2 * (now(v, 0) - 5);
  const ShapeChange change = mesh.changeAt(now);
  EXPECT_NEAR(change.volumes.least, 0.2, 1e-9);
  EXPECT_NEAR(change.volumes.most, 1, 1e-9);
  EXPECT_THAT(change.volumes.shrunk, ElementsAre(ball.vertexCount()));
}

TEST(ShapeChange, APartInsideOutHasANegativeVolume)
{
  const RestingMesh mesh(test::icosphere(1));
  const ShapeChange change = mesh.changeAt(mesh.movedBy([](const Vector3& p) -> Vector3 { return -p; }));
  EXPECT_NEAR(change.volumes.least, -1, 1e-9);
  EXPECT_EQ(change.volumes.shrunkCount, 1);
}

TEST(ShapeChange, OpenPartsHaveNoVolume)
{
  const RestingMesh mesh(test::grid(3, 3));
  EXPECT_EQ(mesh.changeAt(mesh.movedBy([](const Vector3& p) -> Vector3 { return 3 * p; })).volumes.most, 1);
}

TEST(CrossingFaces, OfAPartThatIsPushedThroughAnotherAreNamed)
{
  const Mesh low = test::grid(2, 2);
  const Mesh high = test::moved(test::transformed(low, Eigen::Affine3d(Eigen::Scaling(0.5))), Vector3(0.6, 0.6, 1));
  const RestingMesh mesh(test::merged(low, high));
  Positions now = test::merged(low, high).positions;
  EXPECT_THAT(mesh.crossingAt(now), IsEmpty());
  now.row(low.vertexCount() + 4).z() = -0.4;  // the middle of the small sheet
  const std::vector<Index> crossing = mesh.crossingAt(now);
  EXPECT_TRUE(std::ranges::any_of(crossing, [&](Index face) { return face < low.faces.size(); }));
  EXPECT_TRUE(std::ranges::any_of(crossing, [&](Index face) { return face >= low.faces.size(); }));
}

TEST(CrossingFaces, OfASheetThatPassesThroughItselfAreNamed)
{
  const RestingMesh mesh(test::grid(20, 2));
  // The figure 8, which is in its middle at the angles 0 and pi.
  const auto loop = [](double from, double to) {
    return [=](const Vector3& p) -> Vector3 {
      const double angle = from + (to - from) * p.x() / 20;
      return {8 * std::sin(angle), p.y(), 4 * std::sin(2 * angle)};
    };
  };
  EXPECT_THAT(mesh.crossingAt(mesh.movedBy(loop(0.4, 3))), IsEmpty());
  EXPECT_THAT(mesh.crossingAt(mesh.movedBy(loop(-0.4, 3.6))), testing::Not(IsEmpty()));
}

TEST(CrossingFaces, ThatShareAVertexMayCrossElsewhere)
{
  Positions places(5, 3);
  places << 0, 0, 0, 2, -1, 0, 2, 1, 0, 1.5, 0, -1, 1.5, 0, 1;
  EXPECT_TRUE(areCrossing({0, 1, 2}, {0, 3, 4}, places, 1e-9));
  places.row(3) = Vector3(-1, 0, -1);
  places.row(4) = Vector3(-1, 0, 1);
  EXPECT_FALSE(areCrossing({0, 1, 2}, {0, 3, 4}, places, 1e-9));
  EXPECT_FALSE(areCrossing({0, 1, 2}, {1, 2, 4}, places, 1e-9)) << "they share an edge";
}

TEST(CrossingFaces, ThatTouchDoNotCross)
{
  Positions places(6, 3);
  places << 0, 0, 0, 3, 0, 0, 0, 3, 0, 1, 1, 0, 1, 1, 2, 2, 1, 2;
  EXPECT_FALSE(areCrossing({0, 1, 2}, {3, 4, 5}, places, 1e-9)) << "a corner lies on the face";
  places.row(3).z() = -0.1;
  EXPECT_TRUE(areCrossing({0, 1, 2}, {3, 4, 5}, places, 1e-9));
}

TEST(CrossingFaces, ThatCrossedAtRestAreLeftOut)
{
  const Mesh crossed = test::merged(test::icosphere(1), test::moved(test::icosphere(1), Vector3(1, 0.1, 0.2)));
  const RestingMesh mesh(crossed);
  EXPECT_THAT(mesh.crossingAt(crossed.positions), IsEmpty());
  EXPECT_THAT(mesh.crossingAt(mesh.movedBy([](const Vector3& p) -> Vector3 { return 1.01 * p; })), IsEmpty());
}

}  // namespace
}  // namespace holdfast
