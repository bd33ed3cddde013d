#pragma once
/// The Cholesky factorisation of a dense matrix, on all threads.

#include <optional>

#include <Eigen/Dense>

namespace holdfast {

/// Computes L with A = L L^T in the lower triangle of `A`, of which nothing else is read or written. Returns false
/// where `A` is not positive definite in doubles; what is in it then means nothing. The result is the same on any
/// number of threads. O(n^3).
[[nodiscard]] bool factorizeDense(Eigen::MatrixXd& A);

/// Returns the inverse of the symmetric matrix `A`, or nothing where it is not positive definite in doubles. Three
/// times the cost of a factorisation, and memory for 4 n^2 numbers.
[[nodiscard]] std::optional<Eigen::MatrixXd> inverseOfDefinite(const Eigen::MatrixXd& A);

}  // namespace holdfast
