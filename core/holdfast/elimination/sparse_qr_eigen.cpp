// Sparse QR by Eigen.

#include <algorithm>
#include <numeric>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseQR>

#include <holdfast/elimination/sparse_qr.h>

namespace holdfast {

namespace {

/// Lets its reflections be seen.
template <class Ordering>
class ByEigen : public Eigen::SparseQR<Eigen::SparseMatrix<double>, Ordering> {
 public:
  [[nodiscard]] Reflections reflections() const
  {
    const Index count = std::min(this->rows(), this->cols());
    const SparseRows sorted = this->m_Q.leftCols(count);  // as R below
    Reflections result{sorted, this->m_hcoeffs.head(count), {}};
    result.place.resize(static_cast<std::size_t>(this->rows()));
    std::iota(result.place.begin(), result.place.end(), Index{0});
    return result;
  }
};

template <class Ordering>
SparseQrResult decomposed(const SparseMatrix& M, double tolerance, WantQ wantQ)
{
  SparseMatrix compressed = M;
  compressed.makeCompressed();
  ByEigen<Ordering> qr;
  // Eigen takes columns shorter than the threshold for dependent; 0 accepts all but exact zeros.
  qr.setPivotThreshold(tolerance < 0 ? 0 : tolerance);
  qr.compute(compressed);
  SparseQrResult result;
  result.rank = qr.rank();
  const SparseRows sorted = qr.matrixR();  // Eigen leaves the entries of a column in any order; by rows they are sorted
  result.R = sorted.topRows(result.rank);
  for (Index k = 0; k < M.cols(); ++k) result.columns.push_back(qr.colsPermutation().indices()[k]);
  if (wantQ == WantQ::Yes) result.Q = qr.reflections();
  return result;
}

}  // namespace

SparseQrResult sparseQrEigen(const SparseMatrix& M, double tolerance, WantQ wantQ, ColumnOrder order)
{
  return order == ColumnOrder::AsGiven ? decomposed<Eigen::NaturalOrdering<int>>(M, tolerance, wantQ)
                                       : decomposed<Eigen::COLAMDOrdering<int>>(M, tolerance, wantQ);
}

}  // namespace holdfast
