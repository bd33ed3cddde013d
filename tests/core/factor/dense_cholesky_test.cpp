#include <gtest/gtest.h>

#include <holdfast/factor/dense_cholesky.h>

#include "support/random.h"

namespace holdfast {
namespace {

Eigen::MatrixXd randomDefinite(test::Random& random, Eigen::Index size)
{
  Eigen::MatrixXd some(size, size);
  for (double& number : some.reshaped()) number = random.uniform(-1, 1);
  return some * some.transpose() + 0.1 * Eigen::MatrixXd::Identity(size, size);
}

TEST(DenseCholesky, HasTheLowerFactorOfEigen)
{
  test::Random random(3);
  for (const Eigen::Index size : {1, 2, 127, 128, 129, 300}) {
    const Eigen::MatrixXd A = randomDefinite(random, size);
    Eigen::MatrixXd L = A;
    L.triangularView<Eigen::StrictlyUpper>().setConstant(7);
    ASSERT_TRUE(factorizeDense(L)) << size;
    const Eigen::MatrixXd sevens = Eigen::MatrixXd::Constant(size, size, 7).triangularView<Eigen::StrictlyUpper>();
    EXPECT_EQ(Eigen::MatrixXd(L.triangularView<Eigen::StrictlyUpper>()), sevens) << "nothing else is written";
    const Eigen::MatrixXd lower = L.triangularView<Eigen::Lower>();
    EXPECT_LT((lower * lower.transpose() - A).cwiseAbs().maxCoeff(), 1e-12 * A.cwiseAbs().maxCoeff()) << size;
  }
}

TEST(DenseCholesky, RefusesWhatIsNotDefinite)
{
  test::Random random(4);
  Eigen::MatrixXd A = randomDefinite(random, 200);
  A(150, 150) = -1;
  EXPECT_FALSE(factorizeDense(A));
}

TEST(DenseCholesky, HasTheInverse)
{
  test::Random random(5);
  for (const Eigen::Index size : {1, 2, 128, 129, 300}) {
    const Eigen::MatrixXd A = randomDefinite(random, size);
    const std::optional<Eigen::MatrixXd> inverse = inverseOfDefinite(A);
    ASSERT_TRUE(inverse) << size;
    EXPECT_EQ(*inverse, inverse->transpose());
    EXPECT_LT((A * *inverse - Eigen::MatrixXd::Identity(size, size)).cwiseAbs().maxCoeff(), 1e-9) << size;
  }
  Eigen::MatrixXd A = randomDefinite(random, 200);
  A(150, 150) = -1;
  EXPECT_FALSE(inverseOfDefinite(A));
}

}  // namespace
}  // namespace holdfast
