#include <gtest/gtest.h>

#include <holdfast/matrices/sparse_products.h>

#include "support/random_sparse.h"

namespace holdfast {
namespace {

Columns3 randomColumns(test::Random& random, Index rows)
{
  return Columns3::NullaryExpr(rows, 3, [&] { return random.uniform(-1, 1); });
}

TEST(SparseProducts, AreThoseOfDenseMatrices)
{
  test::Random random(4);
  for (int turn = 0; turn < 50; ++turn) {
    const SparseMatrix M = test::randomSparse(random, random.integer(1, 40), random.integer(1, 40));
    const SparseMatrix N = test::randomSparse(random, M.cols(), random.integer(1, 40));
    const Eigen::MatrixXd dense = M;
    EXPECT_LT((Eigen::MatrixXd(product(M, N)) - dense * Eigen::MatrixXd(N)).cwiseAbs().maxCoeff(), 1e-14);
    const TwoWayMatrix C(M);
    const Columns3 x = randomColumns(random, M.cols());
    const Columns3 f = randomColumns(random, M.rows());
    EXPECT_LT((C.times(x) - dense * x).cwiseAbs().maxCoeff(), 1e-14);
    EXPECT_LT((C.transposeTimes(f) - dense.transpose() * f).cwiseAbs().maxCoeff(), 1e-14);
    EXPECT_LT((C.residual(f, x) - (f - dense * x)).cwiseAbs().maxCoeff(), 1e-14);
  }
}

TEST(SparseProducts, AreAssembledWithAscendingPlaces)
{
  const auto rows = assembled<SparseRows>(10000, 7, [](Index k, ColumnSum& sum) {
    sum.add(static_cast<int>((k + 3) % 7), 1);
    sum.add(static_cast<int>(k % 7), 2);
    sum.add(static_cast<int>((k + 3) % 7), 0.5);
  });
  ASSERT_EQ(rows.nonZeros(), 20000);
  for (Index k = 0; k < rows.rows(); ++k) {
    const int* const place = rows.innerIndexPtr() + rows.outerIndexPtr()[k];
    EXPECT_LT(place[0], place[1]) << k;
    EXPECT_EQ(rows.coeff(k, (k + 3) % 7), 1.5) << k;
    EXPECT_EQ(rows.coeff(k, k % 7), 2) << k;
  }
}

TEST(Gram, IsTheLowerTriangleOfTheProduct)
{
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    test::Random random(seed);
    const SparseMatrix C = test::randomSparse(random, random.integer(1, 20), random.integer(1, 20));
    const SparseMatrix gram = TwoWayMatrix(C).gramLower();
    const Eigen::MatrixXd dense = C;
    const Eigen::MatrixXd product = dense.transpose() * dense;
    const Eigen::MatrixXd expected = product.triangularView<Eigen::Lower>();
    EXPECT_LT((Eigen::MatrixXd(gram) - expected).cwiseAbs().maxCoeff(), 1e-15);
  }
}

TEST(Gram, HasAscendingRowsInEachColumn)
{
  test::Random random(3);
  const SparseMatrix gram = TwoWayMatrix(test::randomSparse(random, 40, 30)).gramLower();
  for (Index j = 0; j < gram.cols(); ++j) {
    int last = -1;
    for (SparseMatrix::InnerIterator entry(gram, j); entry; ++entry) {
      EXPECT_GT(entry.row(), last);
      EXPECT_GE(entry.row(), j);
      last = static_cast<int>(entry.row());
    }
  }
}

}  // namespace
}  // namespace holdfast
