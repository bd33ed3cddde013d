#pragma once
/// The equations that constraints leave.

#include <memory>

#include <holdfast/operators/energy_matrix.h>

namespace holdfast {

/// The columns of A Q2. Most are columns of A, scaled: they are not stored.
class ReducedColumns {
 public:
  /// Both must stay alive and in place as long as this. The other columns are computed here: O(multiplications).
  ReducedColumns(const EnergyMatrix& A, const SparseMatrix& Q2)
      : A_(A), Q2_(Q2), sums_(assembled<SparseMatrix>(A.rows(), Q2.cols(), [&](Index k, ColumnSum& sum) {
          if (isSum(k)) addProduct(sum, A, Q2, k);
        }))
  {
  }

  /// Calls `visit(row, value)` for each entry of the k-th column, rows ascending.
  template <class Visit>
  void forEachInColumn(Index k, const Visit& visit) const
  {
    for (SparseMatrix::InnerIterator entry(isSum(k) ? sums_ : Q2_, k); entry; ++entry)
      if (isSum(k))
        visit(entry.row(), entry.value());
      else
        A_.forEachInColumn(entry.row(), [&](Index row, double value) { visit(row, value * entry.value()); });
  }

 private:
  [[nodiscard]] bool isSum(Index k) const { return Q2_.outerIndexPtr()[k + 1] - Q2_.outerIndexPtr()[k] > 1; }

  const EnergyMatrix& A_;
  const SparseMatrix& Q2_;
  SparseMatrix sums_;
};

/// C = [A Q2; K], as a `LinearMap`. With u = Q2 z it has the equations of A, and rows K of their own. Columns of `P`
/// may follow behind those of Q2.
class ReducedMatrix {
 public:
  /// `A` m x n, `Q2` n x k, `P` n x p, `K` over all k + p columns.
  ReducedMatrix(std::shared_ptr<const EnergyMatrix> A, std::shared_ptr<const TwoWayMatrix> Q2, SparseMatrix P,
                SparseRows K)
      : A_(std::move(A)), Q2_(std::move(Q2)), P_(std::move(P)), K_(std::move(K))
  {
  }

  [[nodiscard]] const std::shared_ptr<const EnergyMatrix>& A() const noexcept { return A_; }
  [[nodiscard]] const std::shared_ptr<const TwoWayMatrix>& Q2() const noexcept { return Q2_; }
  [[nodiscard]] const SparseRows& K() const noexcept { return K_; }

  /// Returns u = [Q2 P] z, n x 3.
  [[nodiscard]] Columns3 spread(const Columns3& z) const;

  /// These return C z, f - C z and C^T f. O(entries of A).
  [[nodiscard]] Columns3 times(const Columns3& z) const;
  [[nodiscard]] Columns3 residual(const Columns3& f, const Columns3& z) const;
  [[nodiscard]] Columns3 transposeTimes(const Columns3& f) const;

  /// Returns the lower triangle of C^T C, without columns of `P`. O(multiplications).
  [[nodiscard]] SparseMatrix gramLower() const;
  /// Returns C as one matrix, without columns of `P`. O(multiplications).
  [[nodiscard]] std::shared_ptr<const TwoWayMatrix> matrix() const;

 private:
  std::shared_ptr<const EnergyMatrix> A_;
  std::shared_ptr<const TwoWayMatrix> Q2_;
  SparseMatrix P_;
  SparseRows K_;
};

}  // namespace holdfast
