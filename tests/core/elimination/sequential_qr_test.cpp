#include <gtest/gtest.h>

#include <holdfast/elimination/sequential_qr.h>

#include "support/random.h"

namespace holdfast {
namespace {

Eigen::MatrixXd randomMatrix(test::Random& random, Index rows, Index columns)
{
  Eigen::MatrixXd M(rows, columns);
  for (double& entry : M.reshaped()) entry = random.uniform(-1, 1);
  return M;
}

TEST(SequentialQr, FactorsMultiplyToTheColumnsAccepted)
{
  for (std::uint32_t seed = 0; seed < 30; ++seed) {
    test::Random random(seed);
    const Index rows = random.integer(1, 12);
    const Index columns = random.integer(1, rows);
    const Eigen::MatrixXd M = randomMatrix(random, rows, columns);
    SequentialQr qr(rows, columns);
    for (Index k = 0; k < columns; ++k) EXPECT_FALSE(qr.add(M.col(k)).has_value());
    ASSERT_EQ(qr.rank(), columns);
    const Eigen::MatrixXd Q = qr.applyQ(Eigen::MatrixXd::Identity(rows, rows));
    EXPECT_LT((Q.transpose() * Q - Eigen::MatrixXd::Identity(rows, rows)).norm(), 1e-13);
    EXPECT_LT((Q.leftCols(columns) * qr.R() - M).norm(), 1e-13);
    EXPECT_TRUE(qr.R().isUpperTriangular(0));
  }
}

TEST(SequentialQr, TellsADependentColumnByItsCoefficientsAndLeavesAllAsItWas)
{
  for (std::uint32_t seed = 0; seed < 30; ++seed) {
    test::Random random(seed);
    const Eigen::MatrixXd M = randomMatrix(random, 9, 4);
    const Eigen::VectorXd coefficients = randomMatrix(random, 4, 1);
    SequentialQr qr(9, 6);
    for (Index k = 0; k < 4; ++k) ASSERT_FALSE(qr.add(M.col(k)).has_value());
    const Eigen::MatrixXd before = qr.R();
    const auto found = qr.add(M * coefficients);
    ASSERT_TRUE(found.has_value());
    EXPECT_LT((*found - coefficients).norm(), 1e-12);
    EXPECT_EQ(qr.R(), before);
    EXPECT_FALSE(qr.add(randomMatrix(random, 9, 1)).has_value());
  }
}

TEST(SequentialQr, AcceptsNoMoreColumnsThanRows)
{
  test::Random random(1);
  SequentialQr qr(3, 10);
  for (int k = 0; k < 3; ++k) EXPECT_FALSE(qr.add(randomMatrix(random, 3, 1)).has_value());
  for (int k = 0; k < 5; ++k) EXPECT_TRUE(qr.add(randomMatrix(random, 3, 1)).has_value());
  EXPECT_EQ(qr.rank(), 3);
}

TEST(SequentialQr, TellsDirectionsApartDownToTheSinePromised)
{
  for (const double sine : {0.9e-12, 1.1e-12}) {
    SequentialQr qr(2, 2);
    EXPECT_FALSE(qr.add(Eigen::Vector2d(1, 0)).has_value());
    EXPECT_EQ(qr.add(Eigen::Vector2d(7, 7 * sine)).has_value(), sine < 1e-12) << sine;
  }
}

TEST(SequentialQr, DoesNotLookAtLengths)
{
  for (const double scale : {1e-100, 1.0, 1e100}) {
    SequentialQr qr(2, 2);
    EXPECT_FALSE(qr.add(scale * Eigen::Vector2d(1, 1)).has_value());
    EXPECT_TRUE(qr.add(Eigen::Vector2d(3, 3)).has_value());
    EXPECT_FALSE(qr.add(Eigen::Vector2d(1, 1 + 1e-9)).has_value());
  }
}

}  // namespace
}  // namespace holdfast
