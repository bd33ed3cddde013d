// Compiled once for each kind of processor, each time with Eigen and `HOLDFAST_PROCESSOR` under names of their own: the
// linker must not take one kind's functions for those of another.

#include <Eigen/Cholesky>

#include <holdfast/factor/dense_kernels_internal.h>

namespace holdfast::HOLDFAST_PROCESSOR {
namespace {

using Matrix = Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>>;
using ConstMatrix = Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>>;

// Eigen's solves with fewer columns spend their time on copies.
constexpr int kFewColumns = 32;

int cholesky(int n, double* A, int ld)
{
  Matrix matrix(A, n, n, Eigen::OuterStride<>(ld));
  return static_cast<int>(Eigen::internal::llt_inplace<double, Eigen::Lower>::blocked(matrix)) + 1;
}

void solveRight(int m, int n, const double* L, int ldL, double* B, int ldB)
{
  Matrix right(B, m, n, Eigen::OuterStride<>(ldB));
  const ConstMatrix lower(L, n, n, Eigen::OuterStride<>(ldL));
  if (n > kFewColumns) {
    lower.transpose().triangularView<Eigen::Upper>().solveInPlace<Eigen::OnTheRight>(right);
    return;
  }
  for (int j = 0; j < n; ++j) {
    if (j > 0) right.col(j).noalias() -= right.leftCols(j) * lower.row(j).head(j).transpose();
    right.col(j) /= lower(j, j);
  }
}

void symmetricUpdate(int n, int k, double factor, const double* A, int ldA, double scale, double* C, int ldC)
{
  Matrix result(C, n, n, Eigen::OuterStride<>(ldC));
  if (scale == 0) result.triangularView<Eigen::Lower>().setZero();
  result.selfadjointView<Eigen::Lower>().rankUpdate(ConstMatrix(A, n, k, Eigen::OuterStride<>(ldA)), factor);
}

void update(int m, int n, int k, double factor, const double* A, const double* B, int ldAB, double scale, double* C,
            int ldC)
{
  Matrix result(C, m, n, Eigen::OuterStride<>(ldC));
  if (scale == 0) result.setZero();
  result.noalias() += factor * ConstMatrix(A, m, k, Eigen::OuterStride<>(ldAB)) *
                      ConstMatrix(B, n, k, Eigen::OuterStride<>(ldAB)).transpose();
}

}  // namespace

extern const DenseKernels kKernels;
constexpr DenseKernels kKernels{cholesky, solveRight, symmetricUpdate, update};

}  // namespace holdfast::HOLDFAST_PROCESSOR
