// The hard solver against dense solutions of the same problem that share no code with it: operators and rows are
// written down again, and solved by LAPACK, in long double, or not at all but judged by what makes a solution one.

#include <gtest/gtest.h>

#include "support/dense_operators.h"
#include "support/dense_svd.h"
#include "support/lapack.h"
#include "support/long_double.h"
#include "support/meshes.h"
#include "support/point_constraints.h"
#include "support/solve_cases.h"

namespace holdfast {
namespace {

ConstraintList independent(const ConstraintList& list, const Mesh& mesh)
{
  const Eigen::MatrixXd B = test::denseRows(list, mesh).B;
  std::vector<Constraint> kept;
  Eigen::MatrixXd accepted(0, B.cols());
  for (Index r = 0; r < B.rows(); ++r) {
    Eigen::MatrixXd larger(accepted.rows() + 1, B.cols());
    larger << accepted, B.row(r);
    if (test::clearRank(larger) == accepted.rows()) continue;
    accepted = larger;
    kept.push_back(list.constraints[r]);
  }
  return test::listOf(kept);
}

/// Some overlapping points of a small mesh, those that depend on others left out, so that all can be met.
test::Problem independentProblem(std::uint32_t seed)
{
  test::Random random(seed);
  const std::vector<Mesh> meshes{test::icosphere(1), test::grid(5, 4), test::box(Vector3(1, 2, 3), 2),
                                 test::plate(5, 4), test::polygonPlate(2, 1)};
  const Mesh& mesh = meshes[seed % meshes.size()];
  const int count = static_cast<int>(random.integer(1, 14));
  return {mesh, independent(test::randomMoves(random, mesh, count, 0.4), mesh)};
}

template <class Check>
void forEachHardProblem(std::uint32_t seeds, Check&& check)
{
  test::forEachProblem(seeds, SolverKind::Hard, independentProblem, check);
}

Eigen::MatrixX3d displacement(const test::Problem& problem, const DeformOptions& options)
{
  const DeformResult result = test::deformed(problem.mesh, problem.list, options);
  EXPECT_EQ(result.report.solve.status, SolveStatus::Ok) << result.report.solve.message;
  return result.positions - problem.mesh.positions;
}

/// A displacement with B u = d, and columns that span those with B u = 0.
struct Reduced {
  Eigen::MatrixXd particular;
  Eigen::MatrixXd N;
};

Reduced reduced(const test::DenseProblem& dense)
{
  return {test::leastSquares(dense.B, dense.d), test::nullSpace(dense.B)};
}

/// What may separate two backward stable solutions, relative to their size: Wedin's bound for the reduced problem, a
/// hundred times because both sides round matrices of about a hundred columns as often in every sum, and the rounding
/// of coordinates, from which displacements are read.
double allowed(const test::Problem& problem, const test::DenseProblem& dense)
{
  const Reduced parts = reduced(dense);
  const double ofCoordinates = 1e-15 * problem.mesh.positions.norm() / parts.particular.norm();
  return 100 * test::roundingBound(dense.A * parts.N, -dense.A * parts.particular) + ofCoordinates;
}

TEST(HardSolver, AgreesWithLapack)
{
  if (!test::constrainedLeastSquaresByLapack(Eigen::Matrix2d::Identity(), Eigen::MatrixXd::Ones(1, 2),
                                             Eigen::Vector2d::Zero(), Eigen::VectorXd::Zero(1)))
    GTEST_SKIP() << "LAPACK was not found when the tests were configured (package liblapack-dev)";
  forEachHardProblem(60, [](const test::Problem& problem, const DeformOptions& options) {
    const test::DenseProblem dense = test::denseProblem(problem.mesh, problem.list, options.weights);
    const Eigen::MatrixXd zero = Eigen::MatrixXd::Zero(dense.A.rows(), 3);
    const auto expected = test::constrainedLeastSquaresByLapack(dense.A, dense.B, zero, dense.d);
    const double tolerance = allowed(problem, dense);
    EXPECT_LT(tolerance, 1e-6) << "the problem is too ill-conditioned to tell anything";
    EXPECT_LT((displacement(problem, options) - *expected).norm(), tolerance * expected->norm());
  });
}

TEST(HardSolver, AgreesWithTheSaddlePointSystemInLongDouble)
{
  forEachHardProblem(30, [](const test::Problem& problem, const DeformOptions& options) {
    const test::DenseProblem dense = test::denseProblem(problem.mesh, problem.list, options.weights);
    const Eigen::MatrixXd expected = test::saddlePointInLongDouble(dense.A, dense.B, dense.d);
    EXPECT_LT((displacement(problem, options) - expected).norm(), allowed(problem, dense) * expected.norm());
  });
}

TEST(HardSolver, LeavesNoSlopeAlongWhatConstraintsLeaveFree)
{
  forEachHardProblem(60, [](const test::Problem& problem, const DeformOptions& options) {
    const test::DenseProblem dense = test::denseProblem(problem.mesh, problem.list, options.weights);
    const Eigen::MatrixXd N = test::nullSpace(dense.B);
    const Eigen::MatrixXd u = displacement(problem, options);
    const Eigen::MatrixXd slope = N.transpose() * (dense.A.transpose() * (dense.A * u));
    // An error e of u makes a slope of |A|^2 e.
    const double size = test::singularValues(dense.A).values[0];
    EXPECT_LT(slope.norm(), size * size * allowed(problem, dense) * u.norm());
  });
}

TEST(HardSolver, HasNoMoreEnergyThanAnyOtherDisplacementThatMeetsTheConstraints)
{
  forEachHardProblem(30, [](const test::Problem& problem, const DeformOptions& options) {
    const test::DenseProblem dense = test::denseProblem(problem.mesh, problem.list, options.weights);
    const Eigen::MatrixXd N = test::nullSpace(dense.B);
    const Eigen::MatrixXd u = displacement(problem, options);
    const double least = (dense.A * u).squaredNorm();
    test::Random random(99);
    for (const double step : {1e-8, 1e-4, 1e-2, 1.0})
      for (int k = 0; k < 5; ++k) {
        const Eigen::MatrixXd z =
            Eigen::MatrixXd::NullaryExpr(N.cols(), 3, [&] { return random.uniform(-step, step); });
        EXPECT_LE(least, (dense.A * (u + N * z)).squaredNorm() * (1 + 1e-12) + 1e-24) << step;
      }
  });
}

TEST(HardSolver, ComparisonsNoticeAnotherWeighting)
{
  const test::Problem problem = independentProblem(3);
  const test::DenseProblem dense = test::denseProblem(problem.mesh, problem.list, Weights::Cotangent);
  const Eigen::MatrixXd expected = test::saddlePointInLongDouble(dense.A, dense.B, dense.d);
  const Eigen::MatrixX3d other = displacement(problem, {Weights::Uniform, {}});
  EXPECT_GT((other - expected).norm(), 1e6 * allowed(problem, dense) * expected.norm());
  EXPECT_GT((dense.A * other).squaredNorm(), (dense.A * expected).squaredNorm() * (1 + 1e-3));
}

TEST(HardSolver, BackendsAgreeOnLargerMeshes)
{
  const Mesh mesh = test::icosphere(4);
  test::Random random(12);
  const ConstraintList list = test::randomMoves(random, mesh, 200, 0.2);
  for (const Weights weights : test::allWeights()) {
    const DeformResult first = test::deformed(mesh, list, {weights, {SolverKind::Hard, Backend::Holdfast, 5}});
    EXPECT_NE(first.report.solve.status, SolveStatus::Failed) << first.report.solve.message;
    for (const Backend backend : test::backends()) {
      const DeformResult other = test::deformed(mesh, list, {weights, {SolverKind::Hard, backend, 5}});
      EXPECT_LT(test::distance(first.positions, other.positions), 1e-11) << name(backend);
    }
  }
}

}  // namespace
}  // namespace holdfast
