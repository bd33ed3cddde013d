#pragma once
/// The numbers of a supernodal factor, laid out for solving, and the triangular solves.

#include <cstddef>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include <holdfast/base/large_memory.h>
#include <holdfast/factor/symbolic_factor.h>
#include <holdfast/factor/top_solve.h>

namespace holdfast {

struct SparseEntries;

/// L, by chunks. Memory is read once from front to back for the solve with L, and back for that with its transpose:
/// both are bound by it.
class PackedFactor {
 public:
  explicit PackedFactor(std::shared_ptr<const SymbolicFactor> symbolic);

  /// Stores the columns of one strip of a supernode: its panel is the first `width` columns of a triangle of `height`
  /// rows in strips.
  void store(int supernode, int strip, const double* panel);

  /// L y = b and then S L^T z = y solve L S L^T z = b for three right-hand sides. `x` is n x 4, row by row in the order
  /// of elimination; the fourth number of each row is not used. The same bits for any number of threads. O(nonzeros).
  void solveForward(std::vector<double>& x) const;
  void solveBackward(std::vector<double>& x) const;

  /// L^-1 P b for columns with few entries each: b in the order of M, the result in that of elimination. Reads only
  /// what is above these entries in the tree.
  [[nodiscard]] SparseMatrix solveForward(const SparseMatrix& b) const;

  /// Columns with -1 in S.
  [[nodiscard]] const std::vector<int>& negative() const noexcept { return negative_; }

  [[nodiscard]] const SymbolicFactor& symbolic() const noexcept { return *symbolic_; }
  [[nodiscard]] std::size_t bytes() const noexcept { return size_ * sizeof(double); }

 private:
  /// A column with few entries: pairs of row and value, in the order of elimination.
  struct FewEntries {
    int column = 0;
    std::vector<std::pair<int, double>> entries;
  };

  /// L^-1 of some columns, `kSolvedAtOnce` at most, by the places of all.
  void solveForward(std::span<const FewEntries> columns, std::vector<SparseEntries>& found) const;

  [[nodiscard]] SolveView viewOf(double* x) const;

  /// The chunks of supernodes [begin, end).
  [[nodiscard]] std::span<const FactorChunk> chunksOf(const SupernodeRange& range) const;

  std::shared_ptr<const SymbolicFactor> symbolic_;
  std::vector<FactorChunk> chunks_;
  std::vector<int> firstChunk_;  // of each supernode, and the end
  std::vector<int> negative_;
  std::size_t size_ = 0;
  LargeArray numbers_;
  TopSolve top_;
};

}  // namespace holdfast
