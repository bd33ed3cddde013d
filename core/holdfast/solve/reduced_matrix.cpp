#include "holdfast/solve/reduced_matrix.h"

#include <cassert>

#include <holdfast/base/parallel.h>

namespace holdfast {

Columns3 ReducedMatrix::spread(const Columns3& z) const
{
  Columns3 u(Q2_->rows().rows(), 3);
  parallelBlocks(u.rows(), [&](Index i) { u.row(i) = gathered(Q2_->rows(), i, z); });
  if (P_.cols() > 0) u += P_ * z.bottomRows(P_.cols());
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
  if (K_.rows() > 0) result += K_.transpose() * f.bottomRows(K_.rows());
  return result;
}

std::shared_ptr<const TwoWayMatrix> ReducedMatrix::matrix() const
{
  assert(P_.cols() == 0);
  const Index equations = A_->rows();
  const SparseMatrix ofK = K_;
  return std::make_shared<const TwoWayMatrix>(
      assembled<SparseMatrix>(equations + K_.rows(), Q2_->columns().cols(), [&](Index k, ColumnSum& sum) {
        addProduct(sum, *A_, Q2_->columns(), k);
        sum.addColumn(ofK, k, equations);
      }));
}

}  // namespace holdfast
