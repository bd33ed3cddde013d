#include "holdfast/solve/gram.h"

namespace holdfast {

SparseMatrix gramLower(const TwoWayMatrix& C)
{
  const SparseRows& rows = C.rows();
  const int* const column = rows.innerIndexPtr();
  return assembled<SparseMatrix>(rows.cols(), rows.cols(), [&](Index j, ColumnSum& sum) {
    for (SparseMatrix::InnerIterator entry(C.columns(), j); entry; ++entry) {
      const int first = rows.outerIndexPtr()[entry.row()];
      for (int k = rows.outerIndexPtr()[entry.row() + 1] - 1; k >= first && column[k] >= j; --k)
        sum.add(column[k], entry.value() * rows.valuePtr()[k]);
    }
  });
}

}  // namespace holdfast
