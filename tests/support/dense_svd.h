#pragma once
/// \file
/// Ranks, null spaces and condition numbers of small matrices, by singular values.

#include <Eigen/Core>

#include <holdfast/numbers/types.h>

namespace holdfast::test {

struct SingularValues {
  Eigen::VectorXd values;  ///< descending
  Eigen::MatrixXd V;       ///< columns x columns
};
[[nodiscard]] SingularValues singularValues(const Eigen::MatrixXd& M);

/// The rank, where it is beyond doubt: fails the running test when a singular value lies between 1e-12 and 1e-8 of the
/// largest.
[[nodiscard]] Index clearRank(const Eigen::MatrixXd& M);

/// Orthonormal columns that span what `M` maps to zero. Of clear rank.
[[nodiscard]] Eigen::MatrixXd nullSpace(const Eigen::MatrixXd& M);

/// The least-squares solution of least length.
[[nodiscard]] Eigen::MatrixXd leastSquares(const Eigen::MatrixXd& M, const Eigen::MatrixXd& rightSides);

/// Bound on the relative error that rounding of C and f by an epsilon each makes in the z that minimises |C z - f|:
/// (k + k^2 tan) epsilon with k the condition number of C with columns of unit length and tan the residual over |C| |z|
/// (Wedin, 1973).
[[nodiscard]] double roundingBound(const Eigen::MatrixXd& C, const Eigen::MatrixXd& f);

}  // namespace holdfast::test
