#include "holdfast/elimination/sparse_qr.h"

namespace holdfast {

Eigen::VectorXd normalizeColumns(SparseMatrix& M)
{
  Eigen::VectorXd lengths(M.cols());
  for (Index k = 0; k < M.cols(); ++k) {
    lengths[k] = M.col(k).norm();
    M.col(k) /= lengths[k];
  }
  return lengths;
}

SparseQrResult sparseQr(const SparseMatrix& M, double tolerance, WantQ wantQ, ColumnOrder order)
{
#ifdef HOLDFAST_WITH_CHOLMOD
  return sparseQrSuiteSparse(M, tolerance, wantQ, order);
#else
  return sparseQrEigen(M, tolerance, wantQ, order);
#endif
}

}  // namespace holdfast
