#include "holdfast/solve/reduced_matrix.h"

#include <cassert>

#include <holdfast/numbers/term.h>
#include <holdfast/threads/parallel.h>

namespace holdfast {

Columns3 ReducedMatrix::spread(const Columns3& z) const
{
  Columns3 u(Q2_->rows().rows(), 3);
  parallelBlocks(u.rows(), [&](Index i) { u.row(i) = gathered(Q2_->rows(), i, z); });
  if (P_.cols() > 0) u.noalias() += P_ * z.bottomRows(P_.cols());
  return u;
}

Columns3 ReducedMatrix::times(const Columns3& z) const
{
  Columns3 result(A_->rows() + K_.rows(), 3);
  result << A_->times(spread(z)), K_ * z;
  return result;
}

Columns3 ReducedMatrix::residual(const Columns3& f, const Columns3& z) const
{
  const Index equations = A_->rows();
  const Columns3 u = spread(z);
  Columns3 result(f.rows(), 3);
  parallelBlocks(f.rows(), [&](Index i) {
    result.row(i) = f.row(i) - (i < equations ? A_->rowTimes(i, u) : gathered(K_, i - equations, z));
  });
  return result;
}

Columns3 ReducedMatrix::transposeTimes(const Columns3& f) const
{
  const Columns3 g = A_->transposeTimes(f);
  const Index own = Q2_->columns().cols();
  Columns3 result(own + P_.cols(), 3);
  parallelBlocks(result.rows(),
                 [&](Index k) { result.row(k) = k < own ? gathered(Q2_->columns(), k, g) : gathered(P_, k - own, g); });
  if (K_.rows() > 0) result.noalias() += K_.transpose() * f.bottomRows(K_.rows());
  return result;
}

SparseMatrix ReducedMatrix::gramLower() const
{
  assert(P_.cols() == 0);
  const SparseRows& rows = Q2_->rows();
  const ReducedColumns columns(*A_, Q2_->columns());
  const SparseMatrix ofK = K_;
  // Most rows of Q2 have one entry, which is found without a search.
  constexpr Term kOthers{-1, 0};
  std::vector<Term> only(static_cast<std::size_t>(rows.rows()), kOthers);
  parallelBlocks(rows.rows(), [&](Index i) {
    const int first = rows.outerIndexPtr()[i];
    if (rows.outerIndexPtr()[i + 1] - first == 1) only[i] = {rows.innerIndexPtr()[first], rows.valuePtr()[first]};
  });
  return assembled<SparseMatrix>(rows.cols(), rows.cols(), [&](Index j, ColumnSum& sum) {
    const auto add = [&](Index k, double value) {
      if (k >= j) sum.add(static_cast<int>(k), value);
    };
    const auto addRow = [&](const SparseRows& M, Index r, double value) {
      for (SparseRows::InnerIterator entry(M, r); entry; ++entry) add(entry.col(), value * entry.value());
    };
    columns.forEachInColumn(j, [&](Index r, double value) {
      A_->forEachInRow(r, [&](Index i, double weight) {
        if (only[i] == kOthers)
          addRow(rows, i, value * weight);
        else
          add(only[i].index, value * weight * only[i].coefficient);
      });
    });
    for (SparseMatrix::InnerIterator entry(ofK, j); entry; ++entry) addRow(K_, entry.row(), entry.value());
  });
}

std::shared_ptr<const TwoWayMatrix> ReducedMatrix::matrix() const
{
  assert(P_.cols() == 0);
  const ReducedColumns columns(*A_, Q2_->columns());
  const SparseMatrix ofK = K_;
  return std::make_shared<const TwoWayMatrix>(
      assembled<SparseMatrix>(A_->rows() + K_.rows(), ofK.cols(), [&](Index k, ColumnSum& sum) {
        columns.forEachInColumn(k, [&](Index row, double value) { sum.add(static_cast<int>(row), value); });
        sum.addColumn(ofK, k, A_->rows());
      }));
}

}  // namespace holdfast
