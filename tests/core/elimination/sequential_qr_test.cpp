#include <cmath>

#include <gtest/gtest.h>

#include <holdfast/elimination/dependency.h>
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

/// Edges of a chain between two pins, one after the other; circuits through it grow by `growth` with every edge.
std::vector<Eigen::VectorXd> closedChain(Index edges, double growth)
{
  std::vector<Eigen::VectorXd> columns{Eigen::VectorXd::Unit(edges + 1, 0)};
  for (Index k = 0; k < edges; ++k)
    columns.emplace_back((growth * Eigen::VectorXd::Unit(edges + 1, k) + Eigen::VectorXd::Unit(edges + 1, k + 1)) /
                         (1 + growth));
  columns.emplace_back(Eigen::VectorXd::Unit(edges + 1, edges));
  return columns;
}

TEST(SequentialQr, TellsDependentColumnsWhoseCoefficientsAreLarge)
{
  // What is left of the last one is rounding times the largest coefficient: more than 1e-12 of its length.
  for (const double growth : {2.0, 3.0, 5.0})
    for (const Index edges : {8, 12, 16}) {
      SCOPED_TRACE(testing::Message() << edges << " edges, growth " << growth);
      const std::vector<Eigen::VectorXd> columns = closedChain(edges, growth);
      SequentialQr qr(edges + 1, edges + 2);
      for (Index k = 0; k <= edges; ++k) ASSERT_FALSE(qr.add(columns[k]).has_value()) << k;
      const auto found = qr.add(columns.back());
      ASSERT_TRUE(found.has_value());
      EXPECT_LT(qr.distance(), kRoundingDistance);
      EXPECT_NEAR(found->head(1)[0], std::pow(-growth, edges), 1e-6 * std::pow(growth, edges));
    }
}

TEST(SequentialQr, SaysHowFarAColumnIsFromTheOthers)
{
  for (const double sine : {1e-3, 1e-7, 1e-11}) {
    SequentialQr qr(2, 2);
    EXPECT_FALSE(qr.add(Eigen::Vector2d(3, 0)).has_value());
    EXPECT_FALSE(qr.add(Eigen::Vector2d(7, 7 * sine)).has_value());
    EXPECT_NEAR(qr.distance(), sine / std::sqrt(2), 1e-3 * sine);
  }
}

TEST(SequentialQr, AppendsWhatIsKnownToBeIndependentHoweverCloseItIs)
{
  SequentialQr qr(2, 2);
  EXPECT_TRUE(qr.append(Eigen::Vector2d(1, 0)));
  EXPECT_FALSE(qr.append(Eigen::Vector2d(2, 0))) << "nothing is left of it";
  EXPECT_TRUE(qr.append(Eigen::Vector2d(1, 1e-15)));
  EXPECT_EQ(qr.rank(), 2);
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
