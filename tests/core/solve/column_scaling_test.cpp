#include <limits>

#include <gtest/gtest.h>

#include <holdfast/solve/column_scaling.h>

#include "support/random_sparse.h"

namespace holdfast {
namespace {

TEST(ColumnScaling, MakesUnitColumns)
{
  test::Random random(8);
  const SparseMatrix M =
      Eigen::MatrixXd(Eigen::MatrixXd::NullaryExpr(7, 5, [&] { return random.uniform(-1e5, 1e5); })).sparseView();
  const auto [scaled, failure] = scaleColumns(SparseMatrix(M));
  ASSERT_EQ(failure, "");
  for (Index k = 0; k < 5; ++k) EXPECT_NEAR(scaled.C.columns().col(k).norm(), 1, 1e-15);
  EXPECT_LT((Eigen::MatrixXd(scaled.C.columns()) - Eigen::MatrixXd(M) * scaled.scale.asDiagonal()).norm(), 1e-15);
}

TEST(ColumnScaling, NamesTheColumnThatCannotBeScaled)
{
  Eigen::MatrixXd M = Eigen::MatrixXd::Identity(3, 3);
  M(1, 1) = 0;
  EXPECT_EQ(scaleColumns(M.sparseView()).failure.substr(0, 14), "unknown 1 of 3");
  M(1, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(scaleColumns(M.sparseView()).failure.substr(0, 14), "unknown 1 of 3");
}

}  // namespace
}  // namespace holdfast
