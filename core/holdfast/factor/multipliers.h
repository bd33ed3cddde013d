#pragma once
/// Multipliers of constraints get their places in an order of elimination.

#include <holdfast/factor/symbolic_factor.h>

namespace holdfast {

/// Returns the structure for [M, K^T; K, 0] from `ofM`, which is that for M + K^T K. `lower` is the lower triangle of
/// the former. It has the columns of M in the order of `ofM`. Behind them it has the multipliers of K's rows, which are
/// independent. The call brings `lower` into the order of the result.
///
/// Gaussian elimination of K in the order of M's columns, with threshold pivoting, matches each row with a column. The
/// multiplier of the row becomes one of the last columns of that column's supernode. Then the rows whose multipliers
/// are in a leading part of the matrix are independent on the columns that are in it. So the part has as many negative
/// eigenvalues as multipliers if M + K^T K is positive definite. Then L S L^T exists, and needs no exchanges.
[[nodiscard]] SymbolicFactor withMultipliers(const SymbolicFactor& ofM, SparseMatrix& lower);

}  // namespace holdfast
