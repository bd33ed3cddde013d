#pragma once
/// These functions make sparse matrices column by column and multiply them by three columns. They use all cores, and
/// the bits are the same for any number of them.

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include <holdfast/numbers/types.h>
#include <holdfast/threads/parallel.h>

namespace holdfast {

/// The entries of neighbouring columns, or of neighbouring rows of a matrix by rows.
struct SparseEntries {
  std::vector<int> places;
  std::vector<double> values;

  /// Reserves memory for `columns` columns when the first `done` of them are there.
  void reserve(Index done, Index columns)
  {
    const auto expected = static_cast<std::size_t>(1.05 * static_cast<double>(columns) / static_cast<double>(done) *
                                                   static_cast<double>(places.size()));
    places.reserve(expected);
    values.reserve(expected);
  }
};

/// Sums the entries of one column at a time.
class ColumnSum {
 public:
  explicit ColumnSum(Index size) : value_(static_cast<std::size_t>(size)), isNamed_(static_cast<std::size_t>(size)) {}

  void add(int place, double value)
  {
    if (isNamed_[place] == 0) {
      isNamed_[place] = 1;
      value_[place] = 0;
      places_.push_back(place);
    }
    value_[place] += value;
  }

  /// Adds the k-th column of M times `factor`, `shift` places further on. For a matrix by rows it adds the k-th row.
  template <class Matrix>
  void addColumn(const Matrix& M, Index k, Index shift = 0, double factor = 1)
  {
    for (typename Matrix::InnerIterator entry(M, k); entry; ++entry)
      add(static_cast<int>(shift + entry.index()), factor * entry.value());
  }

  /// Appends the column to `entries`, places ascending, and starts anew. Returns how many entries it has.
  int moveTo(SparseEntries& entries)
  {
    std::sort(places_.begin(), places_.end());
    for (const int place : places_) {
      entries.places.push_back(place);
      entries.values.push_back(value_[place]);
      isNamed_[place] = 0;
    }
    const auto count = static_cast<int>(places_.size());
    places_.clear();
    return count;
  }

 private:
  std::vector<double> value_;
  std::vector<char> isNamed_;
  std::vector<int> places_;
};

/// Makes the matrix whose k-th column (row of a `SparseRows`) is what `fill(k, sum)` adds to an empty `ColumnSum`.
template <class Matrix, class Fill>
Matrix assembled(Index rows, Index columns, const Fill& fill)
{
  Matrix result(rows, columns);
  constexpr Index kSampled = 500;  // columns that tell how many entries there will be
  const Index count = result.outerSize();
  const Index parts = threadCount();
  const auto firstOf = [&](Index part) { return part * count / parts; };
  std::vector<SparseEntries> entries(static_cast<std::size_t>(parts));
  int* const start = result.outerIndexPtr();
  parallelFor(parts, [&](Index part) {
    ColumnSum sum(result.innerSize());
    const Index first = firstOf(part);
    const Index end = firstOf(part + 1);
    for (Index k = first; k < end; ++k) {
      fill(k, sum);
      start[k + 1] = sum.moveTo(entries[part]);
      if (k - first == kSampled) entries[part].reserve(kSampled + 1, end - first);
    }
  });
  std::partial_sum(start, start + count + 1, start);
  result.resizeNonZeros(start[count]);
  parallelFor(parts, [&](Index part) {
    std::ranges::copy(entries[part].places, result.innerIndexPtr() + start[firstOf(part)]);
    std::ranges::copy(entries[part].values, result.valuePtr() + start[firstOf(part)]);
  });
  return result;
}

/// Makes the matrix of the entries that `forEachEntry(part, add)` passes to `add(row, column, value)`. No place may
/// come twice. The entries of each column (row of a `SparseRows`) come part after part, in the order in which they are
/// passed. Each part is called twice, to count and to add, beside the others.
template <class Matrix, class ForEachEntry>
Matrix sparseMatrix(Index rows, Index columns, Index parts, const ForEachEntry& forEachEntry)
{
  Matrix result(rows, columns);
  std::vector<std::vector<int>> next(static_cast<std::size_t>(parts));  // by column: where its entries of a part go
  parallelFor(parts, [&](Index part) {
    next[part].assign(static_cast<std::size_t>(result.outerSize()), 0);
    forEachEntry(part,
                 [&](Index row, Index column, double /*value*/) { ++next[part][Matrix::IsRowMajor ? row : column]; });
  });
  int* const start = result.outerIndexPtr();
  for (Index k = 0; k < result.outerSize(); ++k) {
    start[k + 1] = start[k];
    for (std::vector<int>& of : next) start[k + 1] += std::exchange(of[k], start[k + 1]);
  }
  result.resizeNonZeros(start[result.outerSize()]);
  parallelFor(parts, [&](Index part) {
    forEachEntry(part, [&](Index row, Index column, double value) {
      const int place = next[part][Matrix::IsRowMajor ? row : column]++;
      result.innerIndexPtr()[place] = static_cast<int>(Matrix::IsRowMajor ? column : row);
      result.valuePtr()[place] = value;
    });
  });
  return result;
}

/// Returns M by rows. O(entries).
[[nodiscard]] inline SparseRows byRows(const SparseMatrix& M)
{
  const Index parts = threadCount();
  return sparseMatrix<SparseRows>(M.rows(), M.cols(), parts, [&](Index part, const auto& add) {
    for (Index k = part * M.cols() / parts; k < (part + 1) * M.cols() / parts; ++k)
      for (SparseMatrix::InnerIterator entry(M, k); entry; ++entry) add(entry.row(), k, entry.value());
  });
}

/// Returns M N. O(multiplications).
[[nodiscard]] inline SparseMatrix product(const SparseMatrix& M, const SparseMatrix& N)
{
  return assembled<SparseMatrix>(M.rows(), N.cols(), [&](Index k, ColumnSum& sum) {
    for (SparseMatrix::InnerIterator n(N, k); n; ++n)
      for (SparseMatrix::InnerIterator m(M, n.row()); m; ++m) sum.add(static_cast<int>(m.row()), m.value() * n.value());
  });
}

/// Returns diag(scale) M. O(entries).
[[nodiscard]] inline SparseMatrix scaledRows(const Eigen::VectorXd& scale, SparseMatrix M)
{
  parallelBlocks(M.cols(), [&](Index k) {
    for (SparseMatrix::InnerIterator entry(M, k); entry; ++entry) entry.valueRef() *= scale[entry.row()];
  });
  return M;
}

/// Returns the sum of the k-th row of M (column where M is by columns) times the rows of x that it names.
template <class Matrix>
Eigen::RowVector3d gathered(const Matrix& M, Index k, const Columns3& x)
{
  Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
  for (typename Matrix::InnerIterator entry(M, k); entry; ++entry) sum += entry.value() * x.row(entry.index());
  return sum;
}

/// A matrix by columns and by rows. Products with it and with its transpose are sums for each row of the result.
class TwoWayMatrix {
 public:
  TwoWayMatrix() = default;
  explicit TwoWayMatrix(SparseMatrix columns) : columns_(std::move(columns)), rows_(byRows(columns_)) {}

  [[nodiscard]] const SparseMatrix& columns() const noexcept { return columns_; }
  [[nodiscard]] const SparseRows& rows() const noexcept { return rows_; }

  /// Returns C x.
  [[nodiscard]] Columns3 times(const Columns3& x) const
  {
    Columns3 result(rows_.rows(), 3);
    parallelBlocks(result.rows(), [&](Index k) { result.row(k) = gathered(rows_, k, x); });
    return result;
  }
  /// Returns C^T f.
  [[nodiscard]] Columns3 transposeTimes(const Columns3& f) const
  {
    Columns3 result(columns_.cols(), 3);
    parallelBlocks(result.rows(), [&](Index k) { result.row(k) = gathered(columns_, k, f); });
    return result;
  }
  /// Returns f - C x, each number rounded as the difference of f and C x.
  [[nodiscard]] Columns3 residual(const Columns3& f, const Columns3& x) const
  {
    Columns3 result(rows_.rows(), 3);
    parallelBlocks(result.rows(), [&](Index k) { result.row(k) = f.row(k) - gathered(rows_, k, x); });
    return result;
  }

  /// Returns the matrix of the normal equations: the lower triangle of C^T C, each column with ascending rows. O(sum of
  /// squares of the row lengths).
  [[nodiscard]] SparseMatrix gramLower() const
  {
    const int* const column = rows_.innerIndexPtr();
    return assembled<SparseMatrix>(rows_.cols(), rows_.cols(), [&](Index j, ColumnSum& sum) {
      for (SparseMatrix::InnerIterator entry(columns_, j); entry; ++entry) {
        const int first = rows_.outerIndexPtr()[entry.row()];
        for (int k = rows_.outerIndexPtr()[entry.row() + 1] - 1; k >= first && column[k] >= j; --k)
          sum.add(column[k], entry.value() * rows_.valuePtr()[k]);
      }
    });
  }

 private:
  SparseMatrix columns_;
  SparseRows rows_;
};

}  // namespace holdfast
