#pragma once
/// Where multipliers of constraints come in an order of elimination.

#include <holdfast/factor/symbolic_factor.h>

namespace holdfast {

/// The structure for [M, K^T; K, 0] from that for M + K^T K, `ofM`. `lower` is the lower triangle of the former: the
/// columns of M in the order of `ofM`, and behind them the multipliers of K's rows, which are independent. It is in the
/// order of the result afterwards.
///
/// Gaussian elimination of K in the order of M's columns, with threshold pivoting, matches each row with a column. Its
/// multiplier becomes one of the last columns of that column's supernode. Then the rows whose multipliers are in a
/// leading part of the matrix are independent on the columns that are in it, so the part has as many negative
/// eigenvalues as multipliers if M + K^T K is positive definite: L S L^T exists, and needs no exchanges.
[[nodiscard]] SymbolicFactor withMultipliers(const SymbolicFactor& ofM, SparseMatrix& lower);

}  // namespace holdfast
