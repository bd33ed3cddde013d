#pragma once
/// These functions are the inner loops of triangular solves.

#include <cstddef>
#include <cstdint>
#include <span>

namespace holdfast {

/// A chunk has so many columns at most: what they need of the solution stays in registers.
inline constexpr int kChunkWidth = 8;

/// A chunk holds neighbouring columns of one supernode. In memory the triangle comes first, by rows, `width` x `width`,
/// with reciprocals on its diagonal. Then come the rows below, `width` numbers each.
struct FactorChunk {
  std::size_t offset = 0;
  int firstColumn = 0;
  int width = 0;
  std::int64_t firstRow = 0;  ///< in `SymbolicFactor::rows`
  int lowRows = 0;            ///< rows before the top of the tree
  int rowCount = 0;           ///< all rows
  bool hasTriangle = true;    ///< else numbers begin with the rows: solves take columns off these, or these off columns
};

/// A view says what chunks are solved on. Rows are four numbers each.
struct SolveView {
  const double* numbers = nullptr;  ///< of the factor
  const int* rows = nullptr;        ///< of its chunks
  double* x = nullptr;              ///< all rows
  double* top = nullptr;            ///< rows from `topColumn` on, for the forward solve: of `x`, or of the range alone
  int topColumn = 0;
};

/// Solves L y = b over these chunks, one after the other. It solves their columns and reduces the rows below.
void solveForward(std::span<const FactorChunk> chunks, const SolveView& view);

/// Solves L^T z = y over these chunks, the last one first.
void solveBackward(std::span<const FactorChunk> chunks, const SolveView& view);

}  // namespace holdfast
