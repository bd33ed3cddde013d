#include <Eigen/QR>

#include "support/long_double.h"

namespace holdfast::test {

Eigen::MatrixXd leastSquaresInLongDouble(const Eigen::MatrixXd& C, const Eigen::MatrixXd& f)
{
  using Long = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
  return Eigen::HouseholderQR<Long>(C.cast<long double>()).solve(f.cast<long double>()).cast<double>();
}

}  // namespace holdfast::test
