#pragma once
/// The equations of a Newton step of many points that pull at one another alike along three axes.

#include <optional>
#include <vector>

#include <Eigen/Dense>

#include <holdfast/numbers/types.h>

namespace holdfast {

/// Solves (diag(K, K, K) + D) y = g. K (k x k) is symmetric and positive definite. D couples the three numbers of each
/// point by a symmetric positive semidefinite 3 x 3 matrix of `blocks`. `g` and y are 3 k numbers, axis by axis. Fails
/// where the matrix is not positive definite in doubles.
///
/// A block is w I and at most two matrices c n n^T more. The inverse of K + diag(w) serves all three axes, and
/// Woodbury's formula adds the rest: some 2 k^3 multiplications, where one factor of all 3 k numbers takes 9 k^3.
[[nodiscard]] std::optional<Eigen::VectorXd> solveBlockNewton(const Eigen::MatrixXd& K,
                                                              const std::vector<Eigen::Matrix3d>& blocks,
                                                              const Eigen::VectorXd& g);

}  // namespace holdfast
