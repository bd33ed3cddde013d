#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/meshes.h"
#include "support/point_constraints.h"
#include "support/solve_cases.h"

namespace holdfast {
namespace {

using test::deformed;
using test::moveBy;
using test::moveTo;
using testing::ElementsAre;
using testing::HasSubstr;

/// How far the point of constraint `c` is from where it is told to be, read off the positions here and not by the
/// engine, as a share of the diagonal.
double missedBy(const ConstraintList& list, std::size_t c, const Mesh& mesh, const Positions& positions)
{
  const auto& point = std::get<PointConstraint>(list.constraints[c].what);
  const auto at = [&](const Positions& p) -> Vector3 {
    if (const auto* vertex = std::get_if<AtVertex>(&point.at)) return p.row(vertex->vertex);
    if (const auto* edge = std::get_if<AtEdge>(&point.at))
      return edge->t * p.row(edge->i) + (1 - edge->t) * p.row(edge->j);
    const auto& face = std::get<AtFace>(point.at);
    Vector3 sum = Vector3::Zero();
    for (std::size_t k = 0; k < face.weights.size(); ++k)
      sum += face.weights[k] * p.row(mesh.faces[face.face][k]).transpose();
    return sum;
  };
  const auto* move = std::get_if<Move>(&point.to);
  const Vector3 target = move == nullptr ? std::get<Target>(point.to).place : Vector3(at(mesh.positions) + move->shift);
  return (at(positions) - target).norm() / boundingBoxDiagonal(mesh.positions);
}

TEST(Deform, MeetsPointsOfEdgesAndFacesThatOverlap)
{
  test::forEachSolveCase([](const Mesh& mesh, const DeformOptions& options) {
    for (std::uint32_t seed = 0; seed < 5; ++seed) {
      test::Random random(seed);
      const ConstraintList list = test::randomMoves(random, mesh, static_cast<int>(2 + 4 * seed), 0.5);
      const DeformResult result = deformed(mesh, list, options);
      ASSERT_NE(result.report.solve.status, SolveStatus::Failed) << result.report.solve.message;
      for (std::size_t c = 0; c < list.constraints.size(); ++c) {
        const ConstraintOutcome& outcome = result.report.constraints[c];
        if (outcome.status == ConstraintStatus::Conflicting) continue;
        EXPECT_LE(missedBy(list, c, mesh, result.positions), 1e-12) << outcome.name;
      }
    }
  });
}

TEST(Deform, PinnedVerticesAreBitExact)
{
  test::forEachSolveCase([](const Mesh& mesh, const DeformOptions& options) {
    test::Random random(2);
    ConstraintList list;
    std::vector<Vector3> targets;
    for (const Index v : mesh.faces[0]) {
      targets.push_back(Vector3(mesh.positions.row(v)) + test::randomVector(random, 0.3));
      list.constraints.push_back(moveTo(AtVertex{v}, targets.back()));
      list.constraints.push_back(test::randomMoves(random, mesh, 1, 0.3).constraints[0]);
    }
    list = test::listOf(list.constraints);
    const DeformResult result = deformed(mesh, list, options);
    ASSERT_NE(result.report.solve.status, SolveStatus::Failed) << result.report.solve.message;
    for (std::size_t k = 0; k < targets.size(); ++k)
      if (result.report.constraints[2 * k].status == ConstraintStatus::Met) {
        EXPECT_EQ(Vector3(result.positions.row(mesh.faces[0][k])), targets[k]);
      }
    EXPECT_EQ(result.report.constraints[0].status, ConstraintStatus::Met);
  });
}

TEST(Deform, PinsAreBitExactWhereFacePointsShareTheirVertices)
{
  test::forEachSolveCase([](const Mesh& mesh, const DeformOptions& options) {
    const Vector3 a(0.1, 0.7, -0.3);
    const Vector3 b(1.1, 1.0 / 3, 0.2);
    const Index first = mesh.faces[0][0];
    const Index second = mesh.faces[0][1];
    std::vector<double> weights(mesh.faces[0].size(), 0);
    weights[0] = weights[1] = 0.3;
    weights.back() += 0.4;
    const DeformResult result = deformed(mesh,
                                         test::listOf({moveBy(AtFace{0, weights}, {0, 0, 0.2}),
                                                       moveTo(AtVertex{first}, a), moveTo(AtVertex{second}, b)}),
                                         options);
    ASSERT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
    EXPECT_EQ(Vector3(result.positions.row(first)), a);
    EXPECT_EQ(Vector3(result.positions.row(second)), b);
    EXPECT_LE(result.report.solve.maxResidualRelative, 1e-12);
  });
}

TEST(Deform, APinThatFollowsFromOthersIsBitExactToo)
{
  test::forEachSolveCase([](const Mesh& mesh, const DeformOptions& options) {
    const Index i = mesh.faces[0][0];
    const Index j = mesh.faces[0][1];
    const Vector3 a(0.1, 0.7, -0.3);
    const Vector3 b(1.1, 1.0 / 3, 0.2);
    const DeformResult result =
        deformed(mesh,
                 test::listOf({moveTo(AtVertex{i}, a), moveTo(AtEdge{i, j, 0.3}, 0.3 * a + 0.7 * b),
                               moveTo(AtVertex{j}, b), moveTo(AtVertex{i}, a)}),
                 options);
    ASSERT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
    EXPECT_EQ(result.report.constraints[2].status, ConstraintStatus::Redundant);
    EXPECT_EQ(result.report.constraints[3].status, ConstraintStatus::Redundant);
    EXPECT_EQ(Vector3(result.positions.row(i)), a);
    EXPECT_EQ(Vector3(result.positions.row(j)), b);
  });
}

TEST(Deform, OfPinsThatContradictTheFirstStands)
{
  const Mesh mesh = test::icosphere(2);
  const DeformResult result = deformed(
      mesh, test::listOf({test::hold({40, 41}), moveTo(AtVertex{7}, {3, 0, 0}), moveTo(AtVertex{7}, {0, 4, 0})}), {});
  EXPECT_EQ(result.report.solve.status, SolveStatus::Conflicts);
  EXPECT_EQ(Vector3(result.positions.row(7)), Vector3(3, 0, 0));
  const ConstraintOutcome& loser = result.report.constraints[2];
  EXPECT_EQ(loser.status, ConstraintStatus::Conflicting);
  EXPECT_THAT(loser.dependsOn, ElementsAre("P1"));
  EXPECT_DOUBLE_EQ(loser.gap.value_or(0), 5);
  EXPECT_DOUBLE_EQ(loser.residual.value_or(0), 5);
  EXPECT_EQ(result.report.solve.maxResidual, 0);
}

TEST(Deform, WithEverythingPinnedHasNothingToSolve)
{
  test::forEachSolveCase([](const Mesh& mesh, const DeformOptions& options) {
    std::vector<Constraint> constraints;
    const Mesh target = test::transformed(mesh, Eigen::Affine3d(Eigen::AngleAxisd(0.3, Vector3::UnitX())));
    for (Index v = 0; v < mesh.vertexCount(); ++v) constraints.push_back(moveTo(AtVertex{v}, target.positions.row(v)));
    const DeformResult result = deformed(mesh, test::listOf(constraints), options);
    EXPECT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
    EXPECT_EQ(result.positions, target.positions);
  });
}

TEST(Deform, WithoutAConstraintLeavesTheMeshAtRest)
{
  test::forEachSolveCase([](const Mesh& mesh, const DeformOptions& options) {
    const DeformResult result = deformed(mesh, {}, options);
    EXPECT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
    EXPECT_EQ(result.positions, mesh.positions);
  });
}

TEST(Deform, FailsByNameWhereTheLiteralWeightsAreUndefined)
{
  Mesh mesh = test::grid(4, 4);
  mesh.positions.row(12) << 1.5, 1, 0;  // between its neighbours 6 and 7
  for (const Backend backend : test::backends()) {
    const DeformResult result = deformed(mesh, test::listOf({test::hold({0, 4}), moveBy(AtVertex{24}, {0, 0, 1})}),
                                         {Weights::CotangentPaper, {SolverKind::Hard, backend, 5}});
    EXPECT_EQ(result.report.solve.status, SolveStatus::Failed);
    EXPECT_THAT(result.report.solve.message, HasSubstr("the first of them vertex "));
    EXPECT_THAT(result.report.solve.message, HasSubstr("use the weights \"cotangent\""));
    EXPECT_EQ(result.positions, mesh.positions);
  }
}

TEST(Deform, CarriesSliversWithTheDefaultWeights)
{
  Mesh mesh = test::grid(4, 4);
  mesh.positions.row(12) << 2, 1 + 1e-9, 0;  // next to vertex 7
  for (const Backend backend : test::backends()) {
    const DeformResult result = deformed(mesh, test::listOf({test::hold({0, 4}), moveBy(AtVertex{24}, {0, 0, 1})}),
                                         {Weights::Cotangent, {SolverKind::Hard, backend, 5}});
    EXPECT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
    EXPECT_LT((result.positions.row(12) - result.positions.row(7)).norm(), 0.2);
    EXPECT_TRUE(std::any_of(result.report.mesh.findings.begin(), result.report.mesh.findings.end(),
                            [](const Finding& finding) { return finding.kind == "capped_cotangents"; }));
  }
}

}  // namespace
}  // namespace holdfast
