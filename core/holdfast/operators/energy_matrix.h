#pragma once
/// This is the matrix of the energy that is minimised.

#include <memory>
#include <utility>

#include <holdfast/matrices/sparse_products.h>
#include <holdfast/threads/parallel.h>

namespace holdfast {

/// An energy matrix is A of |A u - f|^2, m x n. Products with it and with its transpose are sums for each row of the
/// result. It stores diag(scale) S of a symmetric S once. It stores any other matrix twice, by columns and by rows.
class EnergyMatrix {
 public:
  explicit EnergyMatrix(SparseMatrix A)
      : columns_(std::make_shared<const SparseMatrix>(std::move(A))), rows_(byRows(*columns_))
  {
  }
  EnergyMatrix(Eigen::VectorXd scale, std::shared_ptr<const SparseMatrix> S)
      : columns_(std::move(S)), scale_(std::move(scale))
  {
  }

  [[nodiscard]] Index rows() const noexcept { return columns_->rows(); }
  [[nodiscard]] Index cols() const noexcept { return columns_->cols(); }

  /// Calls `visit(row, value)` for each entry of the k-th column, rows ascending.
  template <class Visit>
  void forEachInColumn(Index k, const Visit& visit) const
  {
    for (SparseMatrix::InnerIterator entry(*columns_, k); entry; ++entry)
      visit(entry.row(), isSymmetric() ? scale_[entry.row()] * entry.value() : entry.value());
  }
  /// Calls `visit(column, value)` for each entry of the k-th row, columns ascending.
  template <class Visit>
  void forEachInRow(Index k, const Visit& visit) const
  {
    if (isSymmetric())
      for (SparseMatrix::InnerIterator entry(*columns_, k); entry; ++entry)
        visit(entry.row(), scale_[k] * entry.value());
    else
      for (SparseRows::InnerIterator entry(rows_, k); entry; ++entry) visit(entry.col(), entry.value());
  }

  /// Returns the k-th row of A x. `columnTimes` returns that of A^T f.
  [[nodiscard]] Eigen::RowVector3d rowTimes(Index k, const Columns3& x) const
  {
    return isSymmetric() ? Eigen::RowVector3d(scale_[k] * gathered(*columns_, k, x)) : gathered(rows_, k, x);
  }
  [[nodiscard]] Eigen::RowVector3d columnTimes(Index k, const Columns3& f) const
  {
    Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
    forEachInColumn(k, [&](Index row, double value) { sum += value * f.row(row); });
    return sum;
  }

  /// Returns A x. `residual` returns f - A x, and `transposeTimes` returns A^T f. O(entries).
  [[nodiscard]] Columns3 times(const Columns3& x) const
  {
    Columns3 result(rows(), 3);
    parallelBlocks(rows(), [&](Index k) { result.row(k) = rowTimes(k, x); });
    return result;
  }
  [[nodiscard]] Columns3 residual(const Columns3& f, const Columns3& x) const
  {
    Columns3 result(rows(), 3);
    parallelBlocks(rows(), [&](Index k) { result.row(k) = f.row(k) - rowTimes(k, x); });
    return result;
  }
  [[nodiscard]] Columns3 transposeTimes(const Columns3& f) const
  {
    Columns3 result(cols(), 3);
    parallelBlocks(cols(), [&](Index k) { result.row(k) = columnTimes(k, f); });
    return result;
  }

  /// Returns A, by columns. O(entries).
  [[nodiscard]] SparseMatrix matrix() const { return isSymmetric() ? scaledRows(scale_, *columns_) : *columns_; }

 private:
  [[nodiscard]] bool isSymmetric() const noexcept { return scale_.size() > 0; }

  std::shared_ptr<const SparseMatrix> columns_;  // or S
  SparseRows rows_;                              // not of S
  Eigen::VectorXd scale_;                        // with S
};

/// Adds the k-th column of A N to `sum`.
inline void addProduct(ColumnSum& sum, const EnergyMatrix& A, const SparseMatrix& N, Index k)
{
  for (SparseMatrix::InnerIterator n(N, k); n; ++n)
    A.forEachInColumn(n.row(), [&](Index row, double value) { sum.add(static_cast<int>(row), value * n.value()); });
}

/// Returns A N. `transposeProduct` returns A^T N. O(multiplications).
[[nodiscard]] inline SparseMatrix product(const EnergyMatrix& A, const SparseMatrix& N)
{
  return assembled<SparseMatrix>(A.rows(), N.cols(), [&](Index k, ColumnSum& sum) { addProduct(sum, A, N, k); });
}
[[nodiscard]] inline SparseMatrix transposeProduct(const EnergyMatrix& A, const SparseMatrix& N)
{
  return assembled<SparseMatrix>(A.cols(), N.cols(), [&](Index k, ColumnSum& sum) {
    for (SparseMatrix::InnerIterator n(N, k); n; ++n)
      A.forEachInRow(n.row(),
                     [&](Index column, double value) { sum.add(static_cast<int>(column), value * n.value()); });
  });
}

}  // namespace holdfast
