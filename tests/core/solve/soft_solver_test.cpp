#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/operators/model_size.h>

#include "support/dense_operators.h"
#include "support/dense_svd.h"
#include "support/long_double.h"
#include "support/meshes.h"
#include "support/point_constraints.h"
#include "support/solve_cases.h"

namespace holdfast {
namespace {

using testing::HasSubstr;

test::Problem overlappingProblem(std::uint32_t seed)
{
  test::Random random(seed);
  const std::vector<Mesh> meshes{test::icosphere(1), test::grid(4, 4), test::plate(4, 4), test::polygonPlate(2, 1)};
  const Mesh& mesh = meshes[seed % meshes.size()];
  return {mesh, test::randomMoves(random, mesh, static_cast<int>(random.integer(1, 12)), 0.4)};
}

template <class Check>
void forEachSoftProblem(std::uint32_t seeds, Check&& check)
{
  test::forEachProblem(seeds, SolverKind::Soft, overlappingProblem, check);
}

Eigen::MatrixXd displacement(const test::Problem& problem, DeformOptions options, SolverKind kind, double weight)
{
  options.solver.kind = kind;
  options.solver.softWeight = weight;
  const DeformResult result = test::deformed(problem.mesh, problem.list, options);
  EXPECT_NE(result.report.solve.status, SolveStatus::Failed) << result.report.solve.message;
  return result.positions - problem.mesh.positions;
}

TEST(SoftSolver, AgreesWithTheNormalEquationsInLongDouble)
{
  forEachSoftProblem(40, [](const test::Problem& problem, const DeformOptions& options) {
    const test::DenseProblem dense = test::denseProblem(problem.mesh, problem.list, options.weights);
    for (const double stated : {0.5, 5.0, 50.0}) {
      // A is for lengths in diagonals, the weight for lengths in diameters.
      const double weight =
          stated / rowsInDiameters(options.weights, diameterInDiagonals(test::solverMeshOf(problem.mesh)));
      Eigen::MatrixXd C(dense.A.rows() + dense.B.rows(), dense.A.cols());
      C << dense.A, weight * dense.B;
      Eigen::MatrixXd f = Eigen::MatrixXd::Zero(C.rows(), 3);
      f.bottomRows(dense.B.rows()) = weight * dense.d;
      const Eigen::MatrixXd expected = test::normalEquationsInLongDouble(C, f);
      // Wedin's bound, a hundred times for sums of about a hundred terms, and the rounding of coordinates.
      const double tolerance =
          100 * test::roundingBound(C, f) * expected.norm() + 1e-15 * problem.mesh.positions.norm();
      EXPECT_LT((displacement(problem, options, SolverKind::Soft, stated) - expected).norm(), tolerance) << stated;
    }
  });
}

TEST(SoftSolver, RefusesWeightsThatAreNotPositive)
{
  const test::Problem problem = overlappingProblem(1);
  for (const double weight : {0.0, -5.0, std::numeric_limits<double>::quiet_NaN()}) {
    const DeformResult result =
        test::deformed(problem.mesh, problem.list, {Weights::Uniform, {SolverKind::Soft, Backend::Holdfast, weight}});
    EXPECT_EQ(result.report.solve.status, SolveStatus::Failed);
    EXPECT_THAT(result.report.solve.message, testing::HasSubstr("the soft weight is")) << weight;
  }
}

TEST(SoftSolver, TendsToTheHardOneAsTheWeightGrows)
{
  const Mesh mesh = test::plate(4, 4);
  const ConstraintList list = test::listOf({test::hold({0, 4}), test::moveBy(AtVertex{24}, {0, 0.3, 1}),
                                            test::moveBy(AtFace{9, {0.25, 0.25, 0.5}}, {0.2, 0, -0.4})});
  for (const Weights weights : test::allWeights())
    for (const Backend backend : test::backends()) {
      SCOPED_TRACE(testing::Message() << name(weights) << ", " << name(backend));
      const DeformOptions options{weights, {SolverKind::Hard, backend, 5}};
      const Eigen::MatrixXd hard = displacement({mesh, list}, options, SolverKind::Hard, 0);
      double last = std::numeric_limits<double>::infinity();
      for (const double weight : {0.1, 1.0, 10.0, 100.0, 1e3, 1e4, 1e5}) {
        const double away = (displacement({mesh, list}, options, SolverKind::Soft, weight) - hard).norm();
        EXPECT_LT(away, last) << weight;
        last = away;
      }
      // The distance falls with the square of the weight.
      EXPECT_LT(last, 1e-4 * hard.norm());
    }
}

TEST(SoftSolver, SlidesTheMeshByTheMeanOfTheMovesAsTheWeightVanishes)
{
  const Mesh mesh = test::plate(4, 4);
  const ConstraintList list =
      test::listOf({test::moveBy(AtVertex{0}, {0, 0, 0}), test::moveBy(AtVertex{24}, {0, 0.3, 1}),
                    test::moveBy(AtFace{9, {0.25, 0.25, 0.5}}, {0.3, 0, -0.4})});
  const Eigen::RowVector3d mean(0.1, 0.1, 0.2);
  for (const Weights weights : test::allWeights())
    for (const Backend backend : test::backends()) {
      const Eigen::MatrixXd u =
          displacement({mesh, list}, {weights, {SolverKind::Soft, backend, 5}}, SolverKind::Soft, 1e-5);
      EXPECT_LT((u.rowwise() - mean).cwiseAbs().maxCoeff(), 1e-5) << name(weights) << ", " << name(backend);
    }
}

TEST(SoftSolver, CountsWhatItMissesAndCopiesNoPin)
{
  const Mesh mesh = test::plate(4, 4);
  const DeformResult result =
      test::deformed(mesh, test::listOf({test::hold({0}), test::moveBy(AtVertex{24}, {0, 0, 1})}),
                     {Weights::Cotangent, {SolverKind::Soft, test::backends().front(), 5}});
  EXPECT_EQ(result.report.solve.status, SolveStatus::Ok);
  EXPECT_EQ(result.report.constraints[1].status, ConstraintStatus::Missed);
  EXPECT_GT(result.report.constraints[1].residual.value_or(0), 1e-6);
  EXPECT_THAT(result.report.solve.message, HasSubstr("2 of 2 constraints are met only approximately"));
}

}  // namespace
}  // namespace holdfast
