#include "support/lapack.h"

#include <gtest/gtest.h>

#ifdef HOLDFAST_TESTS_WITH_LAPACK

extern "C" void dgglse_(const int* m, const int* n, const int* p, double* a, const int* lda, double* b, const int* ldb,
                        double* c, double* d, double* x, double* work, const int* lwork, int* info);

namespace holdfast::test {
namespace {

Eigen::VectorXd column(Eigen::MatrixXd A, Eigen::MatrixXd B, Eigen::VectorXd c, Eigen::VectorXd d)
{
  const int m = static_cast<int>(A.rows());
  const int n = static_cast<int>(A.cols());
  const int p = static_cast<int>(B.rows());
  const int workSize = 64 * (m + n + p);
  Eigen::VectorXd work(workSize);
  Eigen::VectorXd x(n);
  int info = 0;
  dgglse_(&m, &n, &p, A.data(), &m, B.data(), &p, c.data(), d.data(), x.data(), work.data(), &workSize, &info);
  EXPECT_EQ(info, 0) << "dgglse failed";
  return x;
}

}  // namespace

std::optional<Eigen::MatrixXd> constrainedLeastSquaresByLapack(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B,
                                                               const Eigen::MatrixXd& c, const Eigen::MatrixXd& d)
{
  Eigen::MatrixXd x(A.cols(), c.cols());
  for (Eigen::Index k = 0; k < c.cols(); ++k) x.col(k) = column(A, B, c.col(k), d.col(k));
  return x;
}

}  // namespace holdfast::test

#else

namespace holdfast::test {

std::optional<Eigen::MatrixXd> constrainedLeastSquaresByLapack(const Eigen::MatrixXd& /*A*/,
                                                               const Eigen::MatrixXd& /*B*/,
                                                               const Eigen::MatrixXd& /*c*/,
                                                               const Eigen::MatrixXd& /*d*/)
{
  return std::nullopt;
}

}  // namespace holdfast::test

#endif
