#pragma once
/// LU factorisation of a square sparse matrix, for the system of Lagrange multipliers.

#include <functional>
#include <optional>

#include <holdfast/numbers/types.h>

namespace holdfast {

/// A factorised system: `solve` takes right-hand sides.
struct SparseLu {
  std::function<Columns3(const Columns3& rightSides)> solve;
  Index nonzeros = 0;
};

/// Factorises K. Returns nothing where the matrix is singular. The function of SuiteSparse (UMFPACK) is defined only
/// where that is built.
[[nodiscard]] std::optional<SparseLu> luBySuiteSparse(const SparseMatrix& K);
[[nodiscard]] std::optional<SparseLu> luByEigen(const SparseMatrix& K);

}  // namespace holdfast
