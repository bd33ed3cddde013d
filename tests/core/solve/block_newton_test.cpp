#include <cmath>

#include <gtest/gtest.h>

#include <holdfast/solve/block_newton.h>

#include "support/random.h"

namespace holdfast {
namespace {

/// Points that pull at one another, and what their bounds add.
struct PullingPoints {
  Eigen::MatrixXd K;
  std::vector<Eigen::Matrix3d> blocks;
  Eigen::VectorXd g;

  /// As one matrix.
  [[nodiscard]] Eigen::MatrixXd whole() const
  {
    const Eigen::Index count = K.rows();
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(3 * count, 3 * count);
    for (Eigen::Index axis = 0; axis < 3; ++axis) result.block(axis * count, axis * count, count, count) = K;
    for (Eigen::Index i = 0; i < count; ++i)
      for (Eigen::Index a = 0; a < 3; ++a)
        for (Eigen::Index b = 0; b < 3; ++b) result(a * count + i, b * count + i) += blocks[i](a, b);
    return result;
  }
};

/// Blocks c n n^T + w I, where c goes over the given powers of ten; each fourth is 0.
PullingPoints pullingPoints(Eigen::Index count, double powers)
{
  test::Random random(8);
  PullingPoints result;
  Eigen::MatrixXd some(count, count);
  for (double& number : some.reshaped()) number = random.uniform(-1, 1);
  result.K = some * some.transpose() + 0.1 * Eigen::MatrixXd::Identity(count, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Vector3 n = Vector3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)).normalized();
    const double c = std::pow(10, random.uniform(-powers, powers));
    const double w = std::pow(10, random.uniform(-powers, powers / 4));
    result.blocks.push_back(i % 4 == 0 ? Eigen::Matrix3d(Eigen::Matrix3d::Zero())
                                       : Eigen::Matrix3d(c * n * n.transpose() + w * Eigen::Matrix3d::Identity()));
  }
  result.g.resize(3 * count);
  for (double& number : result.g) number = random.uniform(-1, 1);
  return result;
}

TEST(BlockNewton, SolvesWhatTheWholeMatrixDoes)
{
  for (const double powers : {0.0, 2.0, 4.0}) {
    const PullingPoints points = pullingPoints(60, powers);
    const std::optional<Eigen::VectorXd> y = solveBlockNewton(points.K, points.blocks, points.g);
    ASSERT_TRUE(y);
    const Eigen::VectorXd expected = points.whole().llt().solve(points.g);
    EXPECT_LT((*y - expected).norm(), 1e-9 * expected.norm()) << powers;
  }
}

TEST(BlockNewton, KeepsDigitsNearBounds)
{
  const PullingPoints points = pullingPoints(60, 12);
  const std::optional<Eigen::VectorXd> y = solveBlockNewton(points.K, points.blocks, points.g);
  ASSERT_TRUE(y);
  const Eigen::VectorXd scale = points.whole().diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::VectorXd missed = points.whole() * *y - points.g;
  EXPECT_LT(scale.cwiseProduct(missed).norm(), 1e-6 * scale.cwiseProduct(points.g).norm());
}

TEST(BlockNewton, RefusesWhatIsNotDefinite)
{
  PullingPoints points = pullingPoints(20, 1);
  points.K(4, 4) = -1;
  EXPECT_FALSE(solveBlockNewton(points.K, points.blocks, points.g));
}

}  // namespace
}  // namespace holdfast
