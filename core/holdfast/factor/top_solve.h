#pragma once
/// Triangular solves with the columns at the top of the tree, which do not fall apart into ranges.

#include <span>
#include <vector>

#include <holdfast/factor/triangular_kernels.h>

namespace holdfast {

/// Neighbouring columns of a supernode are a block. Its triangle is solved by the calling thread, what is below it by
/// all, in parts that do not depend on their number: neither do the bits.
class TopSolve {
 public:
  TopSolve() = default;
  /// The chunks of the top, in the order of elimination.
  explicit TopSolve(std::span<const FactorChunk> chunks);

  /// L y = b and L^T z = y in these columns, and in those alone; `view` is of all rows. O(their numbers).
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
