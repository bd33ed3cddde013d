#include <array>
#include <future>
#include <limits>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/solve/column_scaling.h>
#include <holdfast/solve/corrected_solve.h>
#include <holdfast/solve/least_squares_factor.h>

#include "support/dense_svd.h"
#include "support/long_double.h"
#include "support/meshes.h"
#include "support/solve_cases.h"

namespace holdfast {
namespace {

using testing::HasSubstr;

/// A chain of bars, stiffer by `stiffness` than the ground that holds each joint: row i < n - 1 is x_i - x_(i+1) times
/// the stiffness, row n - 1 + i is x_i.
SparseMatrix chain(Index n, double stiffness)
{
  Eigen::MatrixXd M = Eigen::MatrixXd::Zero(2 * n - 1, n);
  for (Index i = 0; i + 1 < n; ++i) {
    M(i, i) = stiffness;
    M(i, i + 1) = -stiffness;
  }
  M.bottomRows(n).setIdentity();
  return M.sparseView();
}

/// The square of the second difference along a line of points, held at one end: its condition grows with the fourth
/// power of n and is 4e5 at 20.
SparseMatrix heldBeam(Index n)
{
  Eigen::MatrixXd D = 2 * Eigen::MatrixXd::Identity(n, n);
  D.diagonal(1).setConstant(-1);
  D.diagonal(-1).setConstant(-1);
  D(n - 1, n - 1) = 1;
  return (D * D).sparseView();
}

/// Springs between neighbours in a cube of n x n x n points, each held by the ground as well: its factor is so full
/// that CHOLMOD looks for an order by METIS, too.
SparseMatrix cubeOfSprings(Index n)
{
  std::vector<Eigen::Triplet<double>> entries;
  const std::array<Index, 3> steps{1, n, n * n};
  for (Index i = 0; i < n * n * n; ++i) {
    entries.emplace_back(i, i, 6.5);
    for (const Index step : steps) {
      if (i / step % n + 1 == n) continue;
      entries.emplace_back(i, i + step, -1);
      entries.emplace_back(i + step, i, -1);
    }
  }
  SparseMatrix M(n * n * n, n * n * n);
  M.setFromTriplets(entries.begin(), entries.end());
  return M;
}

FactorResult cholesky(const TwoWayMatrix& C, Backend backend)
{
  if (backend == Backend::Holdfast) return choleskyMultifrontal(C);
#ifdef HOLDFAST_WITH_CHOLMOD
  if (backend == Backend::Cholmod) return choleskyBySuiteSparse(C);
#endif
  EXPECT_EQ(backend, Backend::Eigen);
  return choleskyByEigen(C);
}

class Factorize : public testing::TestWithParam<Backend> {};

TEST_P(Factorize, UsesTheNormalEquationsWhereTheyWillDo)
{
  ScaledColumns scaled = scaleColumns(chain(20, 3)).value;
  const Columns3 probe = Columns3::Random(20, 3);
  const FactorResult result = factorize(scaled.C, GetParam(), probe);
  ASSERT_NE(result.value, nullptr) << result.failure;
  EXPECT_THAT(std::string(result.value->method()), HasSubstr("normal equations"));
  EXPECT_GE(result.value->nonzeros(), 20);
  EXPECT_LT((result.value->solve(scaled.C.transposeTimes(scaled.C.times(probe))) - probe).norm(), 1e-10);
}

TEST_P(Factorize, TurnsToSparseQrWhereNormalEquationsAreNotPositiveDefinite)
{
  // With bars 1e9 times as stiff as the ground, 1 + 1e-18 rounds to 1 and pivots vanish; a common move of all joints
  // strains the ground alone, and is found to full accuracy through R.
  const Index n = 6;
  ScaledColumns scaled = scaleColumns(chain(n, 1e9)).value;
  const Columns3 probe = scaled.scale.cwiseInverse().asDiagonal() * Columns3::Ones(n, 3);
  const FactorResult byCholesky = cholesky(scaled.C, GetParam());
  EXPECT_EQ(byCholesky.value, nullptr);
  EXPECT_THAT(byCholesky.failure, HasSubstr("not positive definite"));

  const FactorResult result = factorize(scaled.C, GetParam(), probe);
  ASSERT_NE(result.value, nullptr) << result.failure;
  EXPECT_THAT(std::string(result.value->method()), HasSubstr("sparse QR"));
  Columns3 f = Columns3::Zero(2 * n - 1, 3);
  f.bottomRows(n) << 1, 2, 3, 4, 5, 6, 7, 8, 9, 1, 0, 2, 3, 1, 4, 1, 5, 9;
  const CorrectedSolution solution = correctedSolve(*result.value, scaled.C, scaled.scale, f);
  const Columns3 x = scaled.scale.asDiagonal() * solution.z;
  const Eigen::MatrixXd expected = test::leastSquaresInLongDouble(chain(n, 1e9), f);
  EXPECT_LT((x - expected).norm(), 1e-12 * expected.norm());
}

TEST_P(Factorize, GivesBothReasonsWhereNothingWorks)
{
  Eigen::MatrixXd M = Eigen::MatrixXd::Identity(4, 3);
  M.col(2) = M.col(1);
  ScaledColumns scaled = scaleColumns(M.sparseView()).value;
  const FactorResult result = factorize(scaled.C, GetParam(), Columns3::Ones(3, 3));
  EXPECT_EQ(result.value, nullptr);
  EXPECT_THAT(result.failure, HasSubstr("the normal equations"));
  EXPECT_THAT(result.failure, HasSubstr("not positive definite"));
  EXPECT_THAT(result.failure, HasSubstr("sparse QR finds rank 2 for 3 unknowns"));
}

TEST_P(Factorize, OfNoUnknownsHasNothingToDo)
{
  const TwoWayMatrix none(SparseMatrix(5, 0));
  const FactorResult result = factorize(none, GetParam(), Columns3(0, 3));
  ASSERT_NE(result.value, nullptr);
  EXPECT_EQ(result.value->solve(Columns3::Ones(5, 3)).rows(), 0);
}

TEST_P(Factorize, CorrectionsBringBackTheDigitsThatNormalEquationsLose)
{
  for (Index n = 8; n <= 40; n += 4) {
    SCOPED_TRACE(n);
    ScaledColumns scaled = scaleColumns(heldBeam(n)).value;
    const Eigen::MatrixXd C = scaled.C.columns();
    const Columns3 known = scaled.scale.cwiseInverse().asDiagonal() * Columns3::Ones(n, 3);
    const Columns3 f = C * known;
    const FactorResult result = factorize(scaled.C, GetParam(), known);
    ASSERT_NE(result.value, nullptr) << result.failure;
    ASSERT_THAT(std::string(result.value->method()), HasSubstr("normal equations"));
    const Columns3 expected = scaled.scale.asDiagonal() * test::leastSquaresInLongDouble(C, f);
    const auto error = [&](const Columns3& z) {
      return (scaled.scale.asDiagonal() * z - expected).cwiseAbs().maxCoeff() / expected.cwiseAbs().maxCoeff();
    };
    // Rounding of C alone changes the solution by up to the condition number times epsilon, 1e-10 at 20.
    const Eigen::VectorXd values = test::singularValues(C).values;
    const double unavoidable = values[0] / values[values.size() - 1] * std::numeric_limits<double>::epsilon();
    EXPECT_GT(error(result.value->solve(scaled.C.transposeTimes(f))), 100 * unavoidable);
    const CorrectedSolution corrected = correctedSolve(*result.value, scaled.C, scaled.scale, f);
    EXPECT_LT(error(corrected.z), unavoidable);
    EXPECT_GE(corrected.accuracy, error(corrected.z)) << "the estimate is no less than the error";
    EXPECT_LT(corrected.accuracy, 2 * unavoidable) << "and hardly more than what rounding of C alone can do";
    EXPECT_GE(corrected.corrections, 1);
  }
}

TEST_P(Factorize, ContractionTellsHowMuchOfAnErrorIsLeft)
{
  ScaledColumns scaled = scaleColumns(heldBeam(20)).value;
  const Columns3 probe = Columns3::Random(scaled.scale.size(), 3);
  const FactorResult good = factorize(scaled.C, GetParam(), probe);
  ASSERT_NE(good.value, nullptr);
  EXPECT_LT(contraction(*good.value, scaled.C, probe), 1e-3);
  EXPECT_GT(contraction(*good.value, TwoWayMatrix(3 * scaled.C.columns()), probe), 1);
}

TEST_P(Factorize, OfSparseQrAloneSolvesToo)
{
  ScaledColumns scaled = scaleColumns(chain(15, 10)).value;
  const FactorResult result = seminormalQr(scaled.C, GetParam());
  ASSERT_NE(result.value, nullptr) << result.failure;
  const Columns3 f = Columns3::Random(29, 3);
  const Columns3 expected = test::leastSquares(scaled.C.columns(), f);
  EXPECT_LT((correctedSolve(*result.value, scaled.C, scaled.scale, f).z - expected).norm(), 1e-12);
}

TEST_P(Factorize, IsTheSameBitForBitBesideAnother)
{
  const ScaledColumns scaled = scaleColumns(cubeOfSprings(20)).value;
  const Columns3 g = Columns3::Ones(scaled.scale.size(), 3);
  const auto solved = [&] { return cholesky(scaled.C, GetParam()).value->solve(g); };
  const Columns3 alone = solved();
  std::future<Columns3> other = std::async(std::launch::async, solved);
  EXPECT_EQ(solved(), alone);
  EXPECT_EQ(other.get(), alone);
}

INSTANTIATE_TEST_SUITE_P(Backends, Factorize, testing::ValuesIn(test::backends()),
                         [](const testing::TestParamInfo<Backend>& backend) {
                           return std::string(name(backend.param));
                         });

}  // namespace
}  // namespace holdfast
