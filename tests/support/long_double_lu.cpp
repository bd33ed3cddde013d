#include <Eigen/LU>

#include "support/long_double.h"

namespace holdfast::test {
namespace {

using Long = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

}  // namespace

Eigen::MatrixXd solvedInLongDouble(const Eigen::MatrixXd& K, const Eigen::MatrixXd& rightSides)
{
  return Eigen::FullPivLU<Long>(K.cast<long double>()).solve(rightSides.cast<long double>()).cast<double>();
}

Eigen::MatrixXd normalEquationsInLongDouble(const Eigen::MatrixXd& C, const Eigen::MatrixXd& f)
{
  const Long longC = C.cast<long double>();
  const Long right = longC.transpose() * f.cast<long double>();
  return Eigen::FullPivLU<Long>(longC.transpose() * longC).solve(right).cast<double>();
}

Eigen::MatrixXd saddlePointInLongDouble(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B, const Eigen::MatrixXd& d)
{
  const Eigen::Index n = A.cols();
  Long K = Long::Zero(n + B.rows(), n + B.rows());
  const Long longA = A.cast<long double>();
  K.topLeftCorner(n, n) = longA.transpose() * longA;
  K.bottomLeftCorner(B.rows(), n) = B.cast<long double>();
  K.topRightCorner(n, B.rows()) = B.cast<long double>().transpose();
  Long right = Long::Zero(K.rows(), d.cols());
  right.bottomRows(B.rows()) = d.cast<long double>();
  const Long solution = Eigen::FullPivLU<Long>(K).solve(right);
  return solution.topRows(n).cast<double>();
}

}  // namespace holdfast::test
