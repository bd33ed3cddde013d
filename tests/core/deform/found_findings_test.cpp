#include "holdfast/deform/found_findings.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/geometry/rotation_log.h>

#include "support/law_meshes.h"
#include "support/meshes.h"
#include "support/point_constraints.h"
#include "support/solve_cases.h"

namespace holdfast {
namespace {

using testing::ElementsAre;

DeformOptions whereFound(RotationSource source = RotationSource::Found)
{
  return {Weights::Cotangent, {}, {source, kFoundChange, kMostIterations}};
}

std::vector<Index> endOf(const Mesh& mesh, int axis, bool isHigh)
{
  const double end = isHigh ? mesh.positions.col(axis).maxCoeff() : mesh.positions.col(axis).minCoeff();
  std::vector<Index> ids;
  for (Index v = 0; v < mesh.vertexCount(); ++v)
    if (mesh.positions(v, axis) == end) ids.push_back(v);
  return ids;
}

ConstraintList twisted(const Mesh& mesh, double degrees)
{
  return test::listOf(
      {test::hold(endOf(mesh, 2, false)),
       test::handle(endOf(mesh, 2, true), AxisRotation{{0, 0, 1}, degrees, std::nullopt}, Vector3::Zero())});
}

Mesh longBar()
{
  return test::quadBox(Vector3(1, 1, 6), 8);
}

TEST(LostTurns, AreSaidWhereTheBarComesBackToRest)
{
  const Mesh mesh = longBar();
  for (const double degrees : {720.0, -720.0, 1080.0}) {
    const DeformResult result = test::deformed(mesh, twisted(mesh, degrees), whereFound());
    const bool isAtRest = test::distance(result.positions, mesh.positions) < 0.01;
    const Finding* const finding = test::findingOf(result.report, "turns_lost");
    if (isAtRest) {
      ASSERT_NE(finding, nullptr) << degrees;
      EXPECT_THAT(finding->ids, ElementsAre(1));
    }
  }
}

TEST(LostTurns, AreNotSaidOfTurnsThatTheSurfaceHas)
{
  const Mesh mesh = longBar();
  for (const double degrees : {30.0, 100.0, 170.0, -170.0})
    EXPECT_EQ(test::findingOf(test::deformed(mesh, twisted(mesh, degrees), whereFound()).report, "turns_lost"), nullptr)
        << degrees;
}

/// A field that turns evenly along z.
Columns3 evenTwist(const SolverMesh& mesh, double degrees)
{
  Columns3 q = Columns3::Zero(mesh.unknownCount(), 3);
  const double length = mesh.rest.col(2).maxCoeff();
  for (Index i = 0; i < q.rows(); ++i) q.row(i) = rotationLog(Vector3::UnitZ(), degrees * mesh.rest(i, 2) / length);
  return q;
}

TEST(LostTurns, AreThoseThatLeadElsewhereAlongTheEdges)
{
  const Mesh mesh = longBar();
  const SolverMesh solverMesh = test::solverMeshOf(mesh);
  const double height = 6;
  ConstraintSystem system;
  for (Index i = 0; i < solverMesh.unknownCount(); ++i) {
    if (solverMesh.rest(i, 2) == 0) system.rotations.push_back({i, Vector3::Zero(), 0, true});
    if (solverMesh.rest(i, 2) == height) system.rotations.push_back({i, rotationLog(Vector3::UnitZ(), 720), 1, true});
  }
  EXPECT_FALSE(lostTurns(system, solverMesh, evenTwist(solverMesh, 720))) << "90 degrees from ring to ring";
  Columns3 q = Columns3::Zero(solverMesh.unknownCount(), 3);
  for (const GivenRotation& given : system.rotations) q.row(given.unknown) = given.q.transpose();
  const std::optional<Finding> lost = lostTurns(system, solverMesh, q);
  ASSERT_TRUE(lost);
  EXPECT_THAT(lost->ids, ElementsAre(1));
  // Logs that jump by a whole turn where the rotations do not: the same surface.
  for (Index i = 0; i < q.rows(); ++i)
    if (solverMesh.rest(i, 2) > height / 2) q.row(i) = rotationLog(Vector3::UnitZ(), 720).transpose();
  EXPECT_TRUE(lostTurns(system, solverMesh, q));
}

/// A plate whose ends are pushed towards one another.
ConstraintList pushed(const Mesh& mesh, const Vector3& by)
{
  return test::listOf({test::hold(endOf(mesh, 0, false)), test::handle(endOf(mesh, 0, true), std::monostate{}, by)});
}

/// Tells whether the plate, bent a little to one side before, bends far when its end is pushed.
bool givesWay(Mesh mesh, const Vector3& by, RotationSource source)
{
  const double length = mesh.positions.col(0).maxCoeff();
  const double bump = 0.01 * length;
  for (Index v = 0; v < mesh.vertexCount(); ++v)
    mesh.positions(v, 2) = bump * std::sin(M_PI * mesh.positions(v, 0) / length);
  const Positions bent = test::deformed(mesh, pushed(mesh, by), whereFound(source)).positions;
  return bent.col(2).cwiseAbs().maxCoeff() > 4 * bump;
}

TEST(FlatSaddle, IsSaidOfAFlatPlateThatWouldGiveWay)
{
  for (const Mesh& mesh : {test::grid(12, 6), test::grid(24, 12)})
    for (const RotationSource source : {RotationSource::Found, RotationSource::FoundSmooth})
      for (const double share : {0.1, 0.3}) {
        SCOPED_TRACE(testing::Message() << mesh.vertexCount() << ", " << name(source) << ", " << share);
        const Vector3 by(-share * mesh.positions.col(0).maxCoeff(), 0, 0);
        ASSERT_TRUE(givesWay(mesh, by, source));
        const DeformResult result = test::deformed(mesh, pushed(mesh, by), whereFound(source));
        ASSERT_LT(result.positions.col(2).cwiseAbs().maxCoeff(), 1e-9) << "it stays flat";
        const Finding* const finding = test::findingOf(result.report, "flat_saddle");
        ASSERT_NE(finding, nullptr);
        EXPECT_EQ(finding->idsOf, "solution");
      }
}

TEST(FlatSaddle, IsNotSaidOfAFlatPlateThatStandsThePush)
{
  const Mesh mesh = test::grid(12, 6);
  const Vector3 by(-0.03 * mesh.positions.col(0).maxCoeff(), 0, 0);
  ASSERT_FALSE(givesWay(mesh, by, RotationSource::Found));
  EXPECT_EQ(test::findingOf(test::deformed(mesh, pushed(mesh, by), whereFound()).report, "flat_saddle"), nullptr);
}

TEST(FlatSaddle, IsSaidHoweverThePlateStands)
{
  const Mesh flat = test::grid(10, 10);
  const Eigen::Affine3d motion = Eigen::Translation3d(3, -2, 5) *
                                 Eigen::AngleAxisd(1.1, Vector3(1, 2, 3).normalized()) * Eigen::Affine3d::Identity();
  const Mesh mesh = test::transformed(flat, motion);
  ConstraintList list = pushed(flat, {});
  std::get<HandleConstraint>(list.constraints[1].what).translate = motion.linear() * Vector3(-2, 0.3, 0);
  EXPECT_NE(test::findingOf(test::deformed(mesh, list, whereFound()).report, "flat_saddle"), nullptr);
}

TEST(FlatSaddle, IsNotSaidOfPlatesThatArePulledOrTurnedOrBent)
{
  const Mesh mesh = test::grid(12, 6);
  EXPECT_EQ(test::findingOf(test::deformed(mesh, pushed(mesh, {2, 0, 0}), whereFound()).report, "flat_saddle"),
            nullptr);
  ConstraintList bent = pushed(mesh, {-2, 0, 0});
  bent.constraints.push_back(test::moveBy(AtVertex{45}, {0, 0, 1}));
  EXPECT_EQ(test::findingOf(test::deformed(mesh, bent, whereFound()).report, "flat_saddle"), nullptr);
  const ConstraintList tilted =
      test::listOf({test::handle(endOf(mesh, 0, false), AxisRotation{{1, 2, 3}, 50, Vector3(0, 0, 0)}, {}),
                    test::handle(endOf(mesh, 0, true), AxisRotation{{1, 2, 3}, 50, Vector3(0, 0, 0)}, {})});
  EXPECT_EQ(test::findingOf(test::deformed(mesh, tilted, whereFound()).report, "flat_saddle"), nullptr);
}

}  // namespace
}  // namespace holdfast
