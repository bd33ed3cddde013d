#include "holdfast/solve/gram.h"

#include <algorithm>
#include <vector>

namespace holdfast {
namespace {

/// Sums entries of one column at a time.
class ColumnSum {
 public:
  explicit ColumnSum(Index size)
      : value_(static_cast<std::size_t>(size)), column_(static_cast<std::size_t>(size), kNoColumn)
  {
  }

  void add(int row, int column, double value)
  {
    if (column_[row] == column) {
      value_[row] += value;
      return;
    }
    column_[row] = column;
    value_[row] = value;
    rows_.push_back(row);
  }

  /// Appends the column to `matrix` and starts anew.
  void moveTo(SparseMatrix& matrix, int column)
  {
    std::sort(rows_.begin(), rows_.end());
    matrix.startVec(column);
    for (const int row : rows_) matrix.insertBack(row, column) = value_[row];
    rows_.clear();
  }

 private:
  static constexpr int kNoColumn = -1;

  std::vector<double> value_;
  std::vector<int> column_;  // that `value_` belongs to
  std::vector<int> rows_;
};

}  // namespace

SparseMatrix gramLower(const SparseMatrix& C)
{
  const SparseRows byRows = C;
  const int* const start = byRows.outerIndexPtr();
  const int* const column = byRows.innerIndexPtr();
  const double* const value = byRows.valuePtr();
  SparseMatrix result(C.cols(), C.cols());
  result.reserve(3 * C.nonZeros());
  ColumnSum sum(C.cols());
  for (int j = 0; j < C.cols(); ++j) {
    for (SparseMatrix::InnerIterator entry(C, j); entry; ++entry)
      for (int k = start[entry.row() + 1] - 1; k >= start[entry.row()] && column[k] >= j; --k)
        sum.add(column[k], j, entry.value() * value[k]);
    sum.moveTo(result, j);
  }
  result.finalize();
  return result;
}

}  // namespace holdfast
