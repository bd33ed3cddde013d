#pragma once
/// A packed factor has the numbers of a supernodal factor, laid out for solving. It does the triangular solves.

#include <cstddef>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include <holdfast/factor/symbolic_factor.h>
#include <holdfast/factor/top_solve.h>
#include <holdfast/memory/large_memory.h>

namespace holdfast {

struct SparseEntries;

/// A packed factor holds L by chunks. The solve with L reads memory once from front to back. The solve with its
/// transpose reads it once from back to front. Reading memory is what bounds both.
class PackedFactor {
 public:
  explicit PackedFactor(std::shared_ptr<const SymbolicFactor> symbolic);

  /// Stores the columns of one strip of a supernode. Its panel is the first `width` columns of a triangle of `height`
  /// rows in strips.
  void store(int supernode, int strip, const double* panel);

  /// Solves L y = b, and `solveBackward` then S L^T z = y. Together they solve L S L^T z = b, for three right-hand
  /// sides. `x` is n x 4, row by row in the order of elimination. The fourth number of each row is not used. The bits
  /// are the same for any number of threads. O(nonzeros).
  void solveForward(std::vector<double>& x) const;
  void solveBackward(std::vector<double>& x) const;

  /// Returns L^-1 P b for columns with few entries each. b is in the order of M, the result is in that of elimination.
  /// The solve reads only what is above these entries in the tree.
  [[nodiscard]] SparseMatrix solveForward(const SparseMatrix& b) const;

  /// Returns the columns with -1 in S.
  [[nodiscard]] const std::vector<int>& negative() const noexcept { return negative_; }

  [[nodiscard]] const SymbolicFactor& symbolic() const noexcept { return *symbolic_; }

 private:
  /// A column with few entries has pairs of row and value, in the order of elimination.
  struct FewEntries {
    int column = 0;
    std::vector<std::pair<int, double>> entries;
  };

  /// Finds L^-1 of some columns, `kSolvedAtOnce` at most. `found` has one entry for each of all columns.
  void solveForward(std::span<const FewEntries> columns, std::vector<SparseEntries>& found) const;

  [[nodiscard]] SolveView viewOf(double* x) const;

  /// Returns the chunks of the supernodes [begin, end).
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
