#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/geometry/rotation_log.h>

#include "core/rotation/rotation_cases.h"
#include "support/rounding.h"

namespace holdfast {
namespace {

using test::problemOf;
using test::Random;
using test::randomVector;
using test::rows;
using test::solved;
using test::solverMeshOf;
using test::someUnknowns;

// Fields are solved for to a few units in the last place of the largest rotation; this allows for a thousand.
constexpr double kRoundingOfFields = 1000 * test::kEpsilon;

/// `count` unknowns and the rotation given at each: those of `values` in turn.
struct Boundary {
  std::vector<Index> unknowns;
  Columns3 values;
};
Boundary boundaryOf(const SolverMesh& mesh, const std::vector<Vector3>& values, std::size_t count)
{
  Random random(static_cast<std::uint32_t>(count));
  std::vector<Vector3> all;
  for (std::size_t k = 0; k < count; ++k) all.push_back(values[k % values.size()]);
  return {someUnknowns(random, mesh, count), rows(all)};
}

TEST(RotationField, EqualRotationsOfAllHandlesTurnEverythingEqually)
{
  test::forEachGuardedCase([](const SolverMesh& mesh, Weights weights, Backend backend) {
    const Vector3 q(0.1, -1.7, 0.3);
    const Boundary boundary = boundaryOf(mesh, {q}, 6);
    const RotationField field =
        solved(problemOf(mesh, weights, boundary.unknowns, {{0, 1, 2}, {5, 7}}), backend, boundary.values);
    ASSERT_EQ(field.q.rows(), mesh.unknownCount());
    for (Index i = 0; i < mesh.unknownCount(); ++i)
      EXPECT_TRUE(Vector3(field.q.row(i)) == q || field.q.row(i).isZero(0)) << i;
    EXPECT_TRUE(field.gaps.empty());
    for (const Index i : boundary.unknowns)
      for (Index j = 0; j < mesh.unknownCount(); ++j)
        EXPECT_TRUE(mesh.componentOf[j] != mesh.componentOf[i] || Vector3(field.q.row(j)) == q) << j;
  });
}

TEST(RotationField, GivenRotationsAreCopiedBitForBit)
{
  test::forEachGuardedCase([](const SolverMesh& mesh, Weights weights, Backend backend) {
    Random random(7);
    const std::vector<Index> unknowns = someUnknowns(random, mesh, 8);
    Columns3 values(8, 3);
    for (Index k = 0; k < 8; ++k) values.row(k) = randomVector(random, 30);
    const RotationField field =
        solved(problemOf(mesh, weights, unknowns, {{unknowns[0], unknowns[1]}}), backend, values);
    for (std::size_t k = 0; k < 8; ++k) EXPECT_EQ(field.q.row(unknowns[k]), values.row(static_cast<Index>(k)));
  });
}

TEST(RotationField, OfOneHandleLiesOnTheShortestArc)
{
  test::forEachGuardedCase([](const SolverMesh& mesh, Weights weights, Backend backend) {
    for (const double degrees : {1e-6, 30.0, 170.0}) {
      const Vector3 r = rotationLog(Vector3(1, -2, 0.5), degrees);
      const Boundary boundary = boundaryOf(mesh, {Vector3::Zero(), r}, 6);
      const RotationField field = solved(problemOf(mesh, weights, boundary.unknowns), backend, boundary.values);
      const Eigen::Quaterniond whole = rotationExp(r);
      for (Index i = 0; i < mesh.unknownCount(); ++i) {
        const Vector3 q = field.q.row(i);
        const double share = q.dot(r) / r.squaredNorm();
        EXPECT_GE(share, -kRoundingOfFields);
        EXPECT_LE(share, 1 + kRoundingOfFields);
        EXPECT_LE((q - share * r).norm(), kRoundingOfFields * r.norm());
        const Eigen::Quaterniond onArc = Eigen::Quaterniond::Identity().slerp(share, whole);
        EXPECT_LE((rotationExp(q).coeffs() - onArc.coeffs()).norm(), 1e-12);
      }
    }
  });
}

TEST(RotationField, StaysInTheHullOfThreeRotations)
{
  test::forEachGuardedCase([](const SolverMesh& mesh, Weights weights, Backend backend) {
    Eigen::Matrix3d corners;
    corners.col(0) = rotationLog(Vector3(1, 0.2, 0), 400);
    corners.col(1) = rotationLog(Vector3(0, 1, -0.3), -90);
    corners.col(2) = rotationLog(Vector3(0.1, 0, 1), 30);
    const Boundary boundary = boundaryOf(mesh, {corners.col(0), corners.col(1), corners.col(2)}, 6);
    const RotationField field =
        solved(problemOf(mesh, weights, boundary.unknowns, {{1, 3, 8}}), backend, boundary.values);
    std::vector<bool> isTied(static_cast<std::size_t>(mesh.componentCount), false);
    for (const Index i : boundary.unknowns) isTied[mesh.componentOf[i]] = true;
    for (Index i = 0; i < mesh.unknownCount(); ++i) {
      if (!isTied[mesh.componentOf[i]]) continue;
      const Vector3 shares = corners.inverse() * Vector3(field.q.row(i));
      EXPECT_GE(shares.minCoeff(), -1e-12) << i;
      EXPECT_NEAR(shares.sum(), 1, 1e-12) << i;
    }
  });
}

TEST(RotationField, OfATwistedBarTurnsEachSectionByItsShareOfAnyNumberOfTurns)
{
  const Index divisions = 8;
  const SolverMesh mesh = solverMeshOf(test::box(Vector3(1, 1, 10), divisions));
  std::vector<Index> ends;
  std::vector<Vector3> shares;
  for (Index i = 0; i < mesh.unknownCount(); ++i)
    if (const double share = mesh.rest(i, 2) / 10; share == 0 || share == 1) {
      ends.push_back(i);
      shares.push_back(Vector3(0, 0, share));
    }
  for (const Backend backend : test::backends())
    for (const double degrees : {90.0, 360.0, 720.0, -720.0}) {
      const double whole = rotationLog(Vector3(0, 0, 1), degrees).z();
      const RotationField field = solved(problemOf(mesh, Weights::Cotangent, ends), backend, whole * rows(shares));
      for (Index i = 0; i < mesh.unknownCount(); ++i) {
        // Floors of the weights across right angles, a millionth, change shares by as much as they are.
        EXPECT_NEAR(field.q(i, 2) / whole, mesh.rest(i, 2) / 10, 1e-5);
        EXPECT_EQ(field.q(i, 0), 0);
        EXPECT_EQ(field.q(i, 1), 0);
      }
    }
}

TEST(RotationField, OfATwistedBarGrowsAlongEachOfItsLinesWithEveryWeighting)
{
  const SolverMesh mesh = solverMeshOf(test::box(Vector3(1, 1, 10), 8));
  std::vector<Index> ends;
  std::vector<Vector3> values;
  for (Index i = 0; i < mesh.unknownCount(); ++i)
    if (mesh.rest(i, 2) == 0 || mesh.rest(i, 2) == 10) {
      ends.push_back(i);
      values.push_back(rotationLog(Vector3(0, 0, 1), mesh.rest(i, 2) == 0 ? 0 : 720));
    }
  const auto isBelow = [&](Index i, Index j) {
    return mesh.rest.row(i).head<2>() == mesh.rest.row(j).head<2>() && mesh.rest(i, 2) < mesh.rest(j, 2);
  };
  for (const Weights weights : test::allWeights()) {
    const RotationField field = solved(problemOf(mesh, weights, ends), Backend::Holdfast, rows(values));
    for (Index i = 0; i < mesh.unknownCount(); ++i)
      for (Index j = 0; j < mesh.unknownCount(); ++j)
        EXPECT_TRUE(!isBelow(i, j) || field.q(i, 2) < field.q(j, 2)) << name(weights) << " " << i << " " << j;
  }
}

TEST(RotationField, IsOneRotationInsideEachRegion)
{
  test::forEachGuardedCase([](const SolverMesh& mesh, Weights weights, Backend backend) {
    Random random(3);
    const std::vector<Index> unknowns = someUnknowns(random, mesh, 12);
    const std::vector<Index> given{unknowns[0], unknowns[1], unknowns[2]};
    // Two that overlap in unknown 5, one with a given unknown, one that is empty.
    const std::vector<std::vector<Index>> rigidRegions{{unknowns[3], unknowns[4], unknowns[5]},
                                                       {unknowns[5], unknowns[6], unknowns[7]},
                                                       {unknowns[8], unknowns[1], unknowns[9]},
                                                       {}};
    const RotationField field =
        solved(problemOf(mesh, weights, given, rigidRegions), backend, rows({{0, 0, 0}, {1, 2, 3}, {-1, 0, 2}}));
    for (const int k : {4, 5, 6, 7}) EXPECT_EQ(field.q.row(unknowns[k]), field.q.row(unknowns[3]));
    for (const int k : {8, 9}) EXPECT_EQ(Vector3(field.q.row(unknowns[k])), Vector3(1, 2, 3));
    EXPECT_TRUE(field.gaps.empty());
  });
}

TEST(RotationField, OfARegionWithTwoRotationsFollowsTheFirstAndTellsTheGap)
{
  const SolverMesh mesh = solverMeshOf(test::grid(4, 4));
  const RotationProblem problem = problemOf(mesh, Weights::Cotangent, {12, 7, 0}, {{6, 7, 12, 11}});
  const RotationField field = solved(problem, Backend::Holdfast, rows({{0, 0, 1}, {0, 3, 5}, {0, 0, 0}}));
  EXPECT_EQ(Vector3(field.q.row(12)), Vector3(0, 0, 1));
  EXPECT_EQ(Vector3(field.q.row(7)), Vector3(0, 3, 5));
  for (const Index i : {6, 11}) EXPECT_EQ(Vector3(field.q.row(i)), Vector3(0, 0, 1));
  ASSERT_EQ(field.gaps.size(), 1U);
  EXPECT_EQ(field.gaps[0].given, 1);
  EXPECT_EQ(field.gaps[0].first, 0);
  EXPECT_EQ(field.gaps[0].difference, Vector3(0, 3, 4));
}

TEST(RotationField, IsZeroWhereNothingIsGiven)
{
  const Mesh parts = test::merged(test::merged(test::icosphere(1), test::moved(test::plate(3, 3), {9, 0, 0})),
                                  test::moved(test::tetrahedron(), {0, 9, 0}));
  const SolverMesh mesh = solverMeshOf(test::withVertex(test::withVertex(parts, {5, 5, 5}), {6, 6, 6}));
  const Index lone = mesh.unknownCount() - 2;
  const Vector3 r(1, 2, 3);
  for (const Weights weights : test::allWeights())
    for (const Backend backend : test::backends()) {
      const RotationField field =
          solved(problemOf(mesh, weights, {4, lone}, {{43, 44, 45}}), backend, rows({r, {0, 0, 7}}));
      for (Index i = 0; i < lone; ++i)
        EXPECT_EQ(Vector3(field.q.row(i)), mesh.componentOf[i] == 0 ? r : Vector3(0, 0, 0)) << i;
      EXPECT_EQ(Vector3(field.q.row(lone)), Vector3(0, 0, 7));
      EXPECT_EQ(Vector3(field.q.row(lone + 1)), Vector3(0, 0, 0));
      EXPECT_TRUE(solved(problemOf(mesh, weights, {}), backend, Columns3(0, 3)).q.isZero(0));
    }
}

TEST(RotationField, IsNotCarriedByEdgesOfNoWeight)
{
  const RotationField field =
      solved({4, {{0, 1, 1}, {1, 2, 0}, {2, 3, 1}}, {0}, {}}, Backend::Holdfast, rows({{1, 2, 3}}));
  EXPECT_EQ(Vector3(field.q.row(1)), Vector3(1, 2, 3));
  EXPECT_TRUE(field.q.bottomRows(2).isZero(0));
}

TEST(RotationField, OfAnUnknownThatIsGivenTwiceTakesTheFirst)
{
  const RotationProblem problem = problemOf(solverMeshOf(test::grid(2, 2)), Weights::Uniform, {4, 4, 0});
  const RotationField field = solved(problem, Backend::Holdfast, rows({{1, 0, 0}, {2, 0, 0}, {1, 0, 0}}));
  EXPECT_EQ(field.q.col(0), Eigen::VectorXd::Ones(9));
  ASSERT_EQ(field.gaps.size(), 1U);
  EXPECT_EQ(field.gaps[0].difference, Vector3(1, 0, 0));
}

TEST(RotationField, IsCarriedFromPartToPartByARegionOfBoth)
{
  const SolverMesh mesh = solverMeshOf(test::merged(test::icosphere(1), test::moved(test::icosphere(1), {5, 0, 0})));
  const RotationField field = solved(problemOf(mesh, Weights::Cotangent, {0, 11}, {{20, 42 + 20}}), Backend::Holdfast,
                                     rows({{0, 0, 0}, {0, 0, 2}}));
  for (Index i = 42; i < 84; ++i) EXPECT_NEAR(field.q(i, 2), field.q(20, 2), kRoundingOfFields);
  EXPECT_GT(field.q(20, 2), 0.1);
  EXPECT_LT(field.q(20, 2), 1.9);
}

TEST(RotationField, DoesNotDependOnTheNumberingOfVertices)
{
  for (const test::NamedMesh& named : test::allMeshes()) {
    const SolverMesh mesh = solverMeshOf(named.mesh);
    Random random(11);
    const std::vector<Index> newIdOf = someUnknowns(random, mesh, static_cast<std::size_t>(mesh.unknownCount()));
    const SolverMesh renumbered = solverMeshOf(test::renumbered(named.mesh, newIdOf));
    const auto renamed = [&](std::vector<Index> ids) {
      for (Index& id : ids) id = newIdOf[id];
      return ids;
    };
    const Boundary boundary = boundaryOf(mesh, {{1, 2, 3}, {0, 0, 0}, {-2, 1, 0}}, 6);
    const std::vector<Index> region{2, 9, 4};
    for (const Weights weights : test::guardedWeights()) {
      SCOPED_TRACE(named.name + ", " + std::string(name(weights)));
      const RotationField first =
          solved(problemOf(mesh, weights, boundary.unknowns, {region}), Backend::Holdfast, boundary.values);
      const RotationField second = solved(problemOf(renumbered, weights, renamed(boundary.unknowns), {renamed(region)}),
                                          Backend::Holdfast, boundary.values);
      for (Index i = 0; i < mesh.unknownCount(); ++i)
        EXPECT_LE((first.q.row(i) - second.q.row(newIdOf[i])).norm(), kRoundingOfFields) << i;
    }
  }
}

TEST(RotationField, DoesNotDependOnTheScaleOfTheModel)
{
  for (const Weights weights : test::allWeights())
    for (const double scale : {1e-200, 1e-6, 1e6, 1e200}) {
      const Mesh plate = test::plate(7, 5);
      const SolverMesh mesh = solverMeshOf(plate);
      const SolverMesh scaled = solverMeshOf(test::transformed(plate, Eigen::Affine3d(Eigen::Scaling(scale))));
      const Boundary boundary = boundaryOf(mesh, {{1, 2, 3}, {0, 0, 0}, {-2, 1, 0}}, 6);
      const RotationField first =
          solved(problemOf(mesh, weights, boundary.unknowns), Backend::Holdfast, boundary.values);
      const RotationField second =
          solved(problemOf(scaled, weights, boundary.unknowns), Backend::Holdfast, boundary.values);
      EXPECT_LE((first.q - second.q).cwiseAbs().maxCoeff(), 10 * kRoundingOfFields) << name(weights) << " " << scale;
    }
}

TEST(RotationField, IsLinearInTheGivenRotations)
{
  test::forEachGuardedCase([](const SolverMesh& mesh, Weights weights, Backend backend) {
    const Boundary boundary = boundaryOf(mesh, {{1, 2, 3}, {0, 0, 0}, {-2, 1, 0}}, 9);
    const RotationProblem problem = problemOf(mesh, weights, boundary.unknowns, {{2, 9, 4}});
    const Columns3 other = boundary.values.rowwise().reverse();
    const Columns3 expected = 2 * solved(problem, backend, boundary.values).q - 3 * solved(problem, backend, other).q;
    EXPECT_LE((solved(problem, backend, 2 * boundary.values - 3 * other).q - expected).cwiseAbs().maxCoeff(),
              10 * kRoundingOfFields);
  });
}

TEST(RotationFieldSolver, ServesOtherValuesAsAFreshOneWould)
{
  for (const Weights weights : test::allWeights())
    for (const Backend backend : test::backends()) {
      const SolverMesh mesh = solverMeshOf(test::plate(7, 5));
      const Boundary boundary = boundaryOf(mesh, {{1, 2, 3}, {0, 0, 0}, {-2, 1, 0}}, 6);
      const RotationProblem problem = problemOf(mesh, weights, boundary.unknowns);
      const RotationFieldResult used = makeRotationFieldSolver(problem, backend);
      ASSERT_NE(used.value, nullptr) << used.failure;
      const RotationField first = used.value->solve(-7 * boundary.values);
      EXPECT_EQ(used.value->solve(boundary.values).q, solved(problem, backend, boundary.values).q);
      EXPECT_EQ(used.value->solve(-7 * boundary.values).q, first.q);
    }
}

TEST(RotationFieldSolver, TellsHowWellItSolved)
{
  const SolverMesh mesh = solverMeshOf(test::plate(7, 5));
  const RotationFieldResult result =
      makeRotationFieldSolver(problemOf(mesh, Weights::Cotangent, {0, 47}, {{1, 2, 3}}), Backend::Holdfast);
  ASSERT_NE(result.value, nullptr) << result.failure;
  const RotationField field = result.value->solve(rows({{0, 0, 0}, {1, 1, 1}}));
  EXPECT_LE(field.accuracy, 1e-13);
}

TEST(RotationFieldSolver, NamesAnEdgeWhoseWeightIsNotFinite)
{
  const SolverMesh mesh = solverMeshOf(test::triangle({0, 0, 0}, {1, 0, 0}, {3, 0, 0}));
  const RotationFieldResult result =
      makeRotationFieldSolver(problemOf(mesh, Weights::CotangentPaper, {0}), Backend::Holdfast);
  EXPECT_EQ(result.value, nullptr);
  EXPECT_THAT(result.failure, testing::HasSubstr("the edge between unknowns 0 and 1 is not finite"));
  EXPECT_THAT(result.failure, testing::HasSubstr("use the weights \"cotangent\""));
}

TEST(RotationFieldSolver, GivesTheReasonWhereNegativeWeightsLeaveNoAnswer)
{
  for (const Backend backend : test::backends()) {
    // Unknown 1 is pulled and pushed alike.
    const RotationFieldResult loose = makeRotationFieldSolver({3, {{0, 1, 1}, {1, 2, -1}}, {0, 2}, {}}, backend);
    EXPECT_EQ(loose.value, nullptr);
    EXPECT_THAT(loose.failure, testing::HasSubstr("the rotation field: unknown 0 of 1 is in no equation"));
    // 4 q_1 - 3 q_2 = q_0 and -3 q_1 + 2.25 q_2 = -0.75 q_0: the left sides are multiples of one another.
    const RotationFieldResult together =
        makeRotationFieldSolver({3, {{0, 1, 1}, {0, 2, -0.75}, {1, 2, 3}}, {0}, {}}, backend);
    EXPECT_EQ(together.value, nullptr);
    EXPECT_THAT(together.failure, testing::HasSubstr("the normal equations"));
  }
}

}  // namespace
}  // namespace holdfast
