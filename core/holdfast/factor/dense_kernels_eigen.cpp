// Dense kernels where no LAPACK is built in.

#ifndef HOLDFAST_WITH_CHOLMOD

#include <Eigen/Cholesky>

#include <holdfast/factor/dense_kernels_internal.h>

namespace holdfast {
namespace {

using Matrix = Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>>;
using ConstMatrix = Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>>;

}  // namespace

int denseCholesky(int n, double* A, int ld)
{
  Matrix matrix(A, n, n, Eigen::OuterStride<>(ld));
  return static_cast<int>(Eigen::internal::llt_inplace<double, Eigen::Lower>::blocked(matrix)) + 1;
}

void denseSolveRight(int m, int n, const double* L, int ldL, double* B, int ldB)
{
  Matrix right(B, m, n, Eigen::OuterStride<>(ldB));
  // X L^T = B
  ConstMatrix(L, n, n, Eigen::OuterStride<>(ldL)).triangularView<Eigen::Lower>().solveInPlace(right.transpose());
}

void denseSymmetricUpdate(int n, int k, double factor, const double* A, int ldA, double scale, double* C, int ldC)
{
  const ConstMatrix left(A, n, k, Eigen::OuterStride<>(ldA));
  Matrix result(C, n, n, Eigen::OuterStride<>(ldC));
  if (scale == 0) result.triangularView<Eigen::Lower>().setZero();
  result.selfadjointView<Eigen::Lower>().rankUpdate(left, factor);
}

void denseUpdate(int m, int n, int k, double factor, const double* A, const double* B, int ldAB, double scale,
                 double* C, int ldC)
{
  Matrix result(C, m, n, Eigen::OuterStride<>(ldC));
  if (scale == 0) result.setZero();
  result.noalias() += factor * ConstMatrix(A, m, k, Eigen::OuterStride<>(ldAB)) *
                      ConstMatrix(B, n, k, Eigen::OuterStride<>(ldAB)).transpose();
}

}  // namespace holdfast

#endif
