#pragma once
/// What constraints leave of the equations.

#include <memory>

#include <holdfast/operators/energy_matrix.h>

namespace holdfast {

/// C = [A Q2; K], as a `LinearMap`: with u = Q2 z the equations of A, and rows K of their own. Columns of `P` may go
/// on behind those of Q2.
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

  /// u = [Q2 P] z, n x 3.
  [[nodiscard]] Columns3 spread(const Columns3& z) const;

  /// C z; f - C z; C^T f. O(entries of A).
  [[nodiscard]] Columns3 times(const Columns3& z) const;
  [[nodiscard]] Columns3 residual(const Columns3& f, const Columns3& z) const;
  [[nodiscard]] Columns3 transposeTimes(const Columns3& f) const;

  /// C as one matrix, without columns of `P`. O(multiplications).
  [[nodiscard]] std::shared_ptr<const TwoWayMatrix> matrix() const;

 private:
  std::shared_ptr<const EnergyMatrix> A_;
  std::shared_ptr<const TwoWayMatrix> Q2_;
  SparseMatrix P_;
  SparseRows K_;
};

}  // namespace holdfast
