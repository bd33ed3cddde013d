#pragma once
/// \file
/// Dense solutions with more digits than the engine has.

#include <Eigen/Core>

namespace holdfast::test {

/// K^-1 b in long double by LU with complete pivoting.
[[nodiscard]] Eigen::MatrixXd solvedInLongDouble(const Eigen::MatrixXd& K, const Eigen::MatrixXd& rightSides);

/// The z that minimises |C z - f|, with C^T C z = C^T f formed and solved in long double.
[[nodiscard]] Eigen::MatrixXd normalEquationsInLongDouble(const Eigen::MatrixXd& C, const Eigen::MatrixXd& f);

/// The same z by Householder QR of C in long double.
[[nodiscard]] Eigen::MatrixXd leastSquaresInLongDouble(const Eigen::MatrixXd& C, const Eigen::MatrixXd& f);

/// u of [A^T A, B^T; B, 0] [u; m] = [0; d] in long double: minimises |A u| under B u = d, B of full rank.
[[nodiscard]] Eigen::MatrixXd saddlePointInLongDouble(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B,
                                                      const Eigen::MatrixXd& d);

}  // namespace holdfast::test
