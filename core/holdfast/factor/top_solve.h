#pragma once
/// The columns at the top of the tree do not fall apart into ranges. They have triangular solves of their own.

#include <span>
#include <vector>

#include <holdfast/factor/triangular_kernels.h>

namespace holdfast {

/// Neighbouring columns of a supernode are a block. The calling thread solves its triangle. All threads work on what is
/// below it, in parts that do not depend on their number. So the bits do not depend on it either.
class TopSolve {
 public:
  TopSolve() = default;
  /// `chunks` are those of the top, in the order of elimination.
  explicit TopSolve(std::span<const FactorChunk> chunks);

  /// Solves L y = b, and `backward` L^T z = y, in these columns and in those alone. `view` is of all rows. O(numbers of
  /// these columns).
  void forward(const SolveView& view) const;
  void backward(const SolveView& view) const;

 private:
  struct Block {
    std::vector<FactorChunk> triangle;  // with the rows of the block alone
    std::vector<FactorChunk> below;     // with the rows behind it, the same for all
  };

  std::vector<Block> blocks_;
};

}  // namespace holdfast
