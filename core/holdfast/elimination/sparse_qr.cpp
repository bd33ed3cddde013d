#include "holdfast/elimination/sparse_qr.h"

#include <algorithm>
#include <queue>

namespace holdfast {
namespace {

/// One column at a time, in dense workspaces that are cleared where they were touched.
class ReflectedUnit {
 public:
  explicit ReflectedUnit(const Reflections& reflections)
      : reflections_(reflections),
        byRow_(reflections.h),
        x_(Eigen::VectorXd::Zero(reflections.h.rows())),
        isTouched_(static_cast<std::size_t>(reflections.h.rows()), false),
        isPending_(static_cast<std::size_t>(reflections.h.cols()), false)
  {
  }

  /// H_1 ... H_k e_row: the places that are not zero are `touched()`.
  void reflect(Index row)
  {
    touch(row, reflections_.h.cols());
    x_[row] = 1;
    while (!pending_.empty()) {
      const Index j = pending_.top();
      pending_.pop();
      isPending_[j] = false;
      apply(j);
    }
  }

  [[nodiscard]] const std::vector<Index>& touched() const { return touched_; }
  [[nodiscard]] double at(Index row) const { return x_[row]; }

  void clear()
  {
    for (const Index row : touched_) {
      x_[row] = 0;
      isTouched_[row] = false;
    }
    touched_.clear();
  }

 private:
  /// Reflections before `end` that hang on a row that was zero so far are to come.
  void touch(Index row, Index end)
  {
    if (isTouched_[row]) return;
    isTouched_[row] = true;
    touched_.push_back(row);
    for (SparseRows::InnerIterator entry(byRow_, row); entry && entry.col() < end; ++entry) {
      if (isPending_[entry.col()]) continue;
      isPending_[entry.col()] = true;
      pending_.push(entry.col());
    }
  }

  void apply(Index j)
  {
    double product = 0;
    for (SparseMatrix::InnerIterator entry(reflections_.h, j); entry; ++entry)
      product += entry.value() * x_[entry.row()];
    if (product == 0) return;
    for (SparseMatrix::InnerIterator entry(reflections_.h, j); entry; ++entry) {
      touch(entry.row(), j);
      x_[entry.row()] -= reflections_.tau[j] * product * entry.value();
    }
  }

  const Reflections& reflections_;
  SparseRows byRow_;
  Eigen::VectorXd x_;
  std::vector<bool> isTouched_;
  std::vector<bool> isPending_;
  std::vector<Index> touched_;
  std::priority_queue<Index> pending_;
};

/// x <- H_j x.
void reflect(const Reflections& Q, Index j, Columns3& x)
{
  Eigen::RowVector3d product = Eigen::RowVector3d::Zero();
  for (SparseMatrix::InnerIterator entry(Q.h, j); entry; ++entry) product += entry.value() * x.row(entry.row());
  product *= Q.tau[j];
  for (SparseMatrix::InnerIterator entry(Q.h, j); entry; ++entry) x.row(entry.row()) -= entry.value() * product;
}

}  // namespace

Columns3 Reflections::times(Columns3 x) const
{
  for (Index j = h.cols() - 1; j >= 0; --j) reflect(*this, j, x);
  return x(place, Eigen::all);
}

Columns3 Reflections::transposeTimes(const Columns3& x) const
{
  Columns3 result(x.rows(), 3);
  result(place, Eigen::all) = x;
  for (Index j = 0; j < h.cols(); ++j) reflect(*this, j, result);
  return result;
}

SparseMatrix Reflections::columnsFrom(Index first) const
{
  const Index m = h.rows();
  std::vector<Index> rowAt(static_cast<std::size_t>(m));
  for (Index i = 0; i < m; ++i) rowAt[place[i]] = i;
  SparseMatrix Q(m, m - first);
  ReflectedUnit column(*this);
  for (Index k = first; k < m; ++k) {
    column.reflect(k);
    std::vector<Index> rows;
    for (const Index touched : column.touched()) rows.push_back(rowAt[touched]);
    std::sort(rows.begin(), rows.end());
    Q.startVec(k - first);
    for (const Index row : rows)
      if (const double value = column.at(place[row]); value != 0) Q.insertBack(row, k - first) = value;
    column.clear();
  }
  Q.finalize();
  return Q;
}

Columns3 SparseQrResult::solveSeminormal(const Columns3& g) const
{
  Columns3 z = g(columns, Eigen::all);
  R.transpose().triangularView<Eigen::Lower>().solveInPlace(z);
  R.triangularView<Eigen::Upper>().solveInPlace(z);
  Columns3 result(z.rows(), 3);
  result(columns, Eigen::all) = z;
  return result;
}

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
