#include "support/dense_svd.h"

#include <limits>

#include <Eigen/SVD>
#include <gtest/gtest.h>

namespace holdfast::test {
namespace {

Eigen::JacobiSVD<Eigen::MatrixXd, Eigen::FullPivHouseholderQRPreconditioner> decomposed(const Eigen::MatrixXd& M)
{
  return Eigen::JacobiSVD<Eigen::MatrixXd, Eigen::FullPivHouseholderQRPreconditioner>(
      M, Eigen::ComputeFullU | Eigen::ComputeFullV);
}

}  // namespace

SingularValues singularValues(const Eigen::MatrixXd& M)
{
  const auto svd = decomposed(M);
  return {svd.singularValues(), svd.matrixV()};
}

Index clearRank(const Eigen::MatrixXd& M)
{
  if (M.size() == 0) return 0;
  const Eigen::VectorXd values = singularValues(M).values;
  Index rank = 0;
  for (const double value : values) {
    if (value > 1e-12 * values[0]) ++rank;
    EXPECT_FALSE(value > 1e-12 * values[0] && value < 1e-8 * values[0]) << "the rank is in doubt: " << value;
  }
  return rank;
}

Eigen::MatrixXd nullSpace(const Eigen::MatrixXd& M)
{
  if (M.rows() == 0) return Eigen::MatrixXd::Identity(M.cols(), M.cols());
  return singularValues(M).V.rightCols(M.cols() - clearRank(M));
}

Eigen::MatrixXd leastSquares(const Eigen::MatrixXd& M, const Eigen::MatrixXd& rightSides)
{
  return decomposed(M).solve(rightSides);
}

double roundingBound(const Eigen::MatrixXd& C, const Eigen::MatrixXd& f)
{
  const Eigen::MatrixXd unit = C * C.colwise().norm().cwiseInverse().asDiagonal();
  const auto svd = decomposed(unit);
  const Eigen::VectorXd& values = svd.singularValues();
  const double condition = values[0] / values[values.size() - 1];
  const Eigen::MatrixXd z = svd.solve(f);
  const double tangent = z.isZero(0) ? 0 : (unit * z - f).norm() / (values[0] * z.norm());
  return (condition + condition * condition * tangent) * std::numeric_limits<double>::epsilon();
}

}  // namespace holdfast::test
