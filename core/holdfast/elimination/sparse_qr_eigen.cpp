// Sparse QR by Eigen.

#include <Eigen/OrderingMethods>
#include <Eigen/SparseQR>

#include <holdfast/elimination/sparse_qr.h>

namespace holdfast {

namespace {

template <class Ordering>
SparseQrResult decomposed(const SparseMatrix& M, double tolerance, WantQ wantQ)
{
  SparseMatrix compressed = M;
  compressed.makeCompressed();
  Eigen::SparseQR<SparseMatrix, Ordering> qr;
  // Eigen takes columns shorter than the threshold for dependent; 0 accepts all but exact zeros.
  qr.setPivotThreshold(tolerance < 0 ? 0 : tolerance);
  qr.compute(compressed);
  SparseQrResult result;
  result.rank = qr.rank();
  const SparseRows sorted = qr.matrixR();  // Eigen leaves the entries of a column in any order; by rows they are sorted
  result.R = sorted.topRows(result.rank);
  for (Index k = 0; k < M.cols(); ++k) result.columns.push_back(qr.colsPermutation().indices()[k]);
  if (wantQ == WantQ::Yes) result.Q = qr.matrixQ();
  return result;
}

}  // namespace

SparseQrResult sparseQrEigen(const SparseMatrix& M, double tolerance, WantQ wantQ, ColumnOrder order)
{
  return order == ColumnOrder::AsGiven ? decomposed<Eigen::NaturalOrdering<int>>(M, tolerance, wantQ)
                                       : decomposed<Eigen::COLAMDOrdering<int>>(M, tolerance, wantQ);
}

}  // namespace holdfast
