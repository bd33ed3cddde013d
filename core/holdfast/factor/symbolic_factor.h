#pragma once
/// The structure of a supernodal factor L S L^T = P M P^T, found from the pattern of M alone. S is the identity where M
/// is positive definite; the columns of multipliers have -1 in it.

#include <cstdint>
#include <span>
#include <vector>

#include <holdfast/ordering/elimination_tree.h>

namespace holdfast {

/// Neighbouring columns of L that are stored as one dense block: `width` columns, a triangle on top and below it the
/// same rows for all of them.
struct Supernode {
  int firstColumn = 0;
  int width = 0;
  std::int64_t firstRow = 0;  ///< in `SymbolicFactor::rows`: its own columns, and behind them the rows below
  int rowCount = 0;           ///< rows below the triangle
  int parent = kNoParent;     ///< the supernode of the first of these rows
  int multipliers = 0;        ///< its last columns, so many, have -1 in S

  [[nodiscard]] int height() const noexcept { return width + rowCount; }
  [[nodiscard]] int end() const noexcept { return firstColumn + width; }
};

/// Supernodes that can be computed one after the other while others compute other ranges.
struct SupernodeRange {
  int begin = 0;
  int end = 0;
};

struct SymbolicFactor {
  std::vector<int> order;  ///< the column of M that is eliminated k-th
  std::vector<Supernode> supernodes;
  std::vector<int> rows;                   ///< of all supernodes, those of their columns first, ascending in each
  std::vector<std::vector<int>> children;  ///< of each supernode, ascending

  /// The supernodes in ranges that do not depend on one another, each a set of whole subtrees, and behind them the
  /// rest, which needs all of them. The same for any number of threads.
  std::vector<SupernodeRange> subtrees;
  SupernodeRange top;

  [[nodiscard]] int size() const noexcept { return static_cast<int>(order.size()); }
  /// Those below the triangle.
  [[nodiscard]] std::span<const int> rowsOf(const Supernode& supernode) const
  {
    return {rows.data() + supernode.firstRow + supernode.width, static_cast<std::size_t>(supernode.rowCount)};
  }
  /// The supernode of a column. O(log supernodes).
  [[nodiscard]] int supernodeOf(int column) const;
  /// The supernodes of these columns and all their ancestors, ascending.
  [[nodiscard]] std::vector<int> withAncestors(const std::vector<int>& columns) const;
  /// The first column of `top`.
  [[nodiscard]] int topColumn() const;
  /// Stored entries of L, those that supernodes add among them.
  [[nodiscard]] std::int64_t nonzeros() const;
  /// Of the factorisation.
  [[nodiscard]] double flops() const;
  [[nodiscard]] bool hasMultipliers() const;
};

/// Of a supernode with so many columns and rows below them.
[[nodiscard]] double flopsOf(double width, double rowCount);

/// Analyses the lower triangle `lower` for an order of elimination that keeps fill low: `order[k]` is the column that
/// comes k-th. Columns are reordered among those that are equally good. `lower` is in that order afterwards.
/// O(entries + rows of supernodes).
[[nodiscard]] SymbolicFactor analyze(SparseMatrix& lower, const std::vector<int>& order);

/// Finds all that follows from `lower`, in the order of elimination, the columns of supernodes and the ranges.
void complete(SymbolicFactor& factor, const SparseMatrix& lower);

}  // namespace holdfast
