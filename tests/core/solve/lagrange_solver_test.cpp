#include <gtest/gtest.h>

#include "support/meshes.h"
#include "support/point_constraints.h"
#include "support/solve_cases.h"

namespace holdfast {
namespace {

TEST(LagrangeSolver, AgreesWithTheHardOne)
{
  test::forEachSolveCase([](const Mesh& mesh, DeformOptions options) {
    for (std::uint32_t seed = 0; seed < 4; ++seed) {
      test::Random random(seed);
      const ConstraintList list = test::randomMoves(random, mesh, static_cast<int>(3 + 5 * seed), 0.3);
      options.solver.kind = SolverKind::Hard;
      const DeformResult hard = test::deformed(mesh, list, options);
      options.solver.kind = SolverKind::Lagrange;
      const DeformResult lagrange = test::deformed(mesh, list, options);
      ASSERT_NE(hard.report.solve.status, SolveStatus::Failed) << hard.report.solve.message;
      EXPECT_EQ(lagrange.report.solve.status, hard.report.solve.status) << lagrange.report.solve.message;
      EXPECT_LT(test::distance(lagrange.positions, hard.positions), 1e-9);
    }
  });
}

TEST(LagrangeSolver, HasAnUnknownForEachIndependentRow)
{
  const Mesh mesh = test::icosphere(1);
  const ConstraintList list =
      test::listOf({test::hold({0, 1}), test::moveBy(AtFace{20, {0.5, 0.25, 0.25}}, {0, 0, 1}), test::hold({1})});
  const DeformResult result =
      test::deformed(mesh, list, {Weights::Cotangent, {SolverKind::Lagrange, test::backends().front(), 5}});
  EXPECT_EQ(result.report.solve.unknowns, mesh.vertexCount() + 3);
  EXPECT_GT(result.report.solve.factorNonzeros, 0);
}

/// A grid of squares, pressed to `height` of theirs.
Mesh pressedGrid(double height)
{
  Mesh mesh = test::grid(20, 20);
  mesh.positions.col(1) *= height;
  return mesh;
}

/// The grid with vertices held at a corner, the one in the middle moved, and a point of a face elsewhere.
DeformResult solved(SolverKind kind, Weights weights, Backend backend, double height)
{
  const ConstraintList list = test::listOf({test::hold({0, 1, 2}), test::moveTo(AtVertex{220}, {10.5, 0, 1}),
                                            test::moveBy(AtFace{301, {0.25, 0.25, 0.5}}, {0, 0, 1})});
  return test::deformed(pressedGrid(height), list, {weights, {kind, backend, 5}});
}

TEST(LagrangeSolver, PinsThatItMissesAreCalledMissed)
{
  // Eigen's LU does not refine what it solves.
  const DeformResult lagrange = solved(SolverKind::Lagrange, Weights::Cotangent, Backend::Eigen, 0.03);
  const Report& report = lagrange.report;
  ASSERT_EQ(report.solve.status, SolveStatus::Ok) << report.solve.message;
  EXPECT_EQ(report.constraints[1].status, ConstraintStatus::Missed);
  EXPECT_GT(*report.constraints[1].residual, 1e-12 * report.mesh.bboxDiagonal);
  const Eigen::RowVector3d target(10.5, 0, 1);
  EXPECT_DOUBLE_EQ(*report.constraints[1].residual, (lagrange.positions.row(220) - target).norm());
  EXPECT_GE(report.solve.maxResidual, *report.constraints[1].residual);
  EXPECT_NE(report.solve.message.find("met only approximately"), std::string::npos) << report.solve.message;

  const DeformResult hard = solved(SolverKind::Hard, Weights::Cotangent, Backend::Eigen, 0.03);
  EXPECT_EQ(hard.report.constraints[1].status, ConstraintStatus::Met);
  EXPECT_EQ(hard.positions.row(220), target);
}

TEST(LagrangeSolver, TellsHowFarItIsFromTheSolution)
{
  for (const Weights weights : {Weights::Cotangent, Weights::CotangentPaper})
    for (const Backend backend : test::backends())
      for (const double height : {1.0, 0.3, 0.1}) {
        const DeformResult lagrange = solved(SolverKind::Lagrange, weights, backend, height);
        const DeformResult hard = solved(SolverKind::Hard, weights, backend, height);
        SCOPED_TRACE(testing::Message() << name(weights) << ", " << name(backend) << ", " << height);
        ASSERT_EQ(lagrange.report.solve.status, SolveStatus::Ok) << lagrange.report.solve.message;
        const double largest = (hard.positions - pressedGrid(height).positions).cwiseAbs().maxCoeff();
        const double error = (lagrange.positions - hard.positions).cwiseAbs().maxCoeff() / largest;
        EXPECT_GT(error, 2 * hard.report.solve.accuracy) << "the hard solution is the better one";
        EXPECT_GT(lagrange.report.solve.accuracy, error / 3);
        EXPECT_LT(lagrange.report.solve.accuracy, error * 3);
      }
}

TEST(LagrangeSolver, FailsWhereItHasTooFewDigits)
{
  for (const Backend backend : test::backends())
    for (const double height : {1e-4, 1e-6}) {
      const DeformResult lagrange = solved(SolverKind::Lagrange, Weights::Cotangent, backend, height);
      EXPECT_EQ(lagrange.report.solve.status, SolveStatus::Failed) << name(backend) << ", " << height;
      const DeformResult hard = solved(SolverKind::Hard, Weights::Cotangent, backend, height);
      EXPECT_EQ(hard.report.solve.status, SolveStatus::Ok) << name(backend) << ": " << hard.report.solve.message;
    }
}

TEST(LagrangeSolver, IsNotBelievedWhereItsFactorFindsNoKnownSolution)
{
  // A corrected step by such a factor would be small, and say nothing.
  for (const Backend backend : test::backends())
    for (const SolverKind kind : {SolverKind::Lagrange, SolverKind::Hard}) {
      const SolveReport report = solved(kind, Weights::CotangentPaper, backend, 1e-6).report.solve;
      EXPECT_EQ(report.status, SolveStatus::Failed) << name(backend) << ", " << name(kind);
      EXPECT_NE(report.message.find("of an error"), std::string::npos) << report.message;
    }
}

}  // namespace
}  // namespace holdfast
