#pragma once
/// LU factorisation of a square sparse matrix, for the system of Lagrange multipliers.

#include <memory>
#include <string>

#include <holdfast/base/types.h>

namespace holdfast {

class SparseLu {
 public:
  virtual ~SparseLu() = default;
  [[nodiscard]] virtual Columns3 solve(const Columns3& rightSides) const = 0;
  [[nodiscard]] virtual Index nonzeros() const = 0;

 protected:
  SparseLu() = default;
  SparseLu(const SparseLu&) = default;
  SparseLu& operator=(const SparseLu&) = default;
};

/// The factor, or null where the matrix is singular. That of SuiteSparse (UMFPACK) is defined where that is built.
[[nodiscard]] std::unique_ptr<const SparseLu> luBySuiteSparse(const SparseMatrix& K);
[[nodiscard]] std::unique_ptr<const SparseLu> luByEigen(const SparseMatrix& K);

}  // namespace holdfast
