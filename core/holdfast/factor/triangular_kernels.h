#pragma once
/// The inner loops of triangular solves.

#include <span>

#include <holdfast/factor/packed_factor.h>

namespace holdfast {

/// What chunks are solved on. Rows are four numbers each.
struct SolveView {
  const double* numbers = nullptr;  ///< of the factor
  const int* rows = nullptr;        ///< of its chunks
  double* x = nullptr;              ///< all rows
  double* top = nullptr;            ///< rows from `topColumn` on, for the forward solve: of `x`, or of the range alone
  int topColumn = 0;
};

/// L y = b over these chunks, one after the other: their columns are solved, rows below are reduced.
void solveForward(std::span<const FactorChunk> chunks, const SolveView& view);

/// L^T z = y over these chunks, the last one first.
void solveBackward(std::span<const FactorChunk> chunks, const SolveView& view);

}  // namespace holdfast
