#pragma once
/// \file
/// LAPACK's own solver of the problem that the engine solves, where LAPACK was found.

#include <optional>

#include <Eigen/Core>

namespace holdfast::test {

/// x that minimises |A x - c| under B x = d by dgglse, one column after the other; nothing in a build without LAPACK.
/// Fails the running test when LAPACK reports a failure.
[[nodiscard]] std::optional<Eigen::MatrixXd> constrainedLeastSquaresByLapack(const Eigen::MatrixXd& A,
                                                                             const Eigen::MatrixXd& B,
                                                                             const Eigen::MatrixXd& c,
                                                                             const Eigen::MatrixXd& d);

}  // namespace holdfast::test
