#include <gtest/gtest.h>

#include <holdfast/operators/energy_matrix.h>

#include "support/random_sparse.h"

namespace holdfast {
namespace {

constexpr Index kSize = 30;

SparseMatrix symmetric(test::Random& random)
{
  const SparseMatrix M = test::randomSparse(random, kSize, kSize);
  return M + SparseMatrix(M.transpose());
}

TEST(EnergyMatrix, IsTheSameMatrixStoredOnceOrTwice)
{
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    test::Random random(seed);
    const SparseMatrix S = symmetric(random);
    const Eigen::VectorXd scale = Eigen::VectorXd::NullaryExpr(kSize, [&] { return random.uniform(0.5, 2); });
    const Eigen::MatrixXd dense = scale.asDiagonal() * Eigen::MatrixXd(S);
    const Columns3 x = Columns3::Random(kSize, 3);
    const SparseMatrix N = test::randomSparse(random, kSize, 7);
    for (const EnergyMatrix& A : {EnergyMatrix(scale, std::make_shared<const SparseMatrix>(S)),
                                  EnergyMatrix(SparseMatrix(dense.sparseView(1, 0)))}) {
      const auto error = [](const Eigen::MatrixXd& found, const Eigen::MatrixXd& expected) {
        return (found - expected).cwiseAbs().maxCoeff();
      };
      EXPECT_LT(error(A.matrix(), dense), 1e-15);
      EXPECT_LT(error(A.times(x), dense * x), 1e-14);
      EXPECT_LT(error(A.residual(x, x), x - dense * x), 1e-14);
      EXPECT_LT(error(A.transposeTimes(x), dense.transpose() * x), 1e-14);
      EXPECT_LT(error(product(A, N), dense * Eigen::MatrixXd(N)), 1e-14);
      EXPECT_LT(error(transposeProduct(A, N), dense.transpose() * Eigen::MatrixXd(N)), 1e-14);
      Eigen::MatrixXd byRows = Eigen::MatrixXd::Zero(kSize, kSize);
      Eigen::MatrixXd byColumns = byRows;
      for (Index k = 0; k < kSize; ++k) {
        A.forEachInRow(k, [&](Index column, double value) { byRows(k, column) += value; });
        A.forEachInColumn(k, [&](Index row, double value) { byColumns(row, k) += value; });
      }
      EXPECT_LT(error(byRows, dense), 1e-15);
      EXPECT_EQ(byColumns, byRows) << "bit for bit";
    }
  }
}

}  // namespace
}  // namespace holdfast
