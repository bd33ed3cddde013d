#include "holdfast/elimination/householder_vectors.h"

#include <algorithm>
#include <queue>

namespace holdfast {
namespace {

/// One column at a time, in dense workspaces that are cleared where they were touched.
class ReflectedUnit {
 public:
  explicit ReflectedUnit(const HouseholderVectors& vectors)
      : vectors_(vectors),
        byRow_(vectors.h),
        x_(Eigen::VectorXd::Zero(vectors.h.rows())),
        isTouched_(static_cast<std::size_t>(vectors.h.rows()), false),
        isPending_(static_cast<std::size_t>(vectors.h.cols()), false)
  {
  }

  /// H_1 ... H_k e_row: the places that are not zero are `touched()`.
  void reflect(Index row)
  {
    touch(row, vectors_.h.cols());
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
    for (SparseMatrix::InnerIterator entry(vectors_.h, j); entry; ++entry) product += entry.value() * x_[entry.row()];
    if (product == 0) return;
    for (SparseMatrix::InnerIterator entry(vectors_.h, j); entry; ++entry) {
      touch(entry.row(), j);
      x_[entry.row()] -= vectors_.tau[j] * product * entry.value();
    }
  }

  const HouseholderVectors& vectors_;
  SparseRows byRow_;
  Eigen::VectorXd x_;
  std::vector<bool> isTouched_;
  std::vector<bool> isPending_;
  std::vector<Index> touched_;
  std::priority_queue<Index> pending_;
};

}  // namespace

SparseMatrix explicitQ(const HouseholderVectors& vectors)
{
  const Index m = vectors.h.rows();
  std::vector<Index> rowAt(static_cast<std::size_t>(m));
  for (Index i = 0; i < m; ++i) rowAt[vectors.place[i]] = i;
  SparseMatrix Q(m, m);
  ReflectedUnit column(vectors);
  for (Index k = 0; k < m; ++k) {
    column.reflect(k);
    std::vector<Index> rows;
    for (const Index place : column.touched()) rows.push_back(rowAt[place]);
    std::sort(rows.begin(), rows.end());
    Q.startVec(k);
    for (const Index row : rows)
      if (const double value = column.at(vectors.place[row]); value != 0) Q.insertBack(row, k) = value;
    column.clear();
  }
  Q.finalize();
  return Q;
}

}  // namespace holdfast
