#pragma once
/// A symbolic factor is the structure of a supernodal factor L S L^T = P M P^T, found from the pattern of M alone. S is
/// the identity where M is positive definite. The columns of multipliers have -1 in it.

#include <cstdint>
#include <span>
#include <vector>

#include <holdfast/ordering/elimination_tree.h>

namespace holdfast {

/// A supernode is neighbouring columns of L that are stored as one dense block. It has `width` columns, with a triangle
/// on top. Below the triangle all of them have the same rows.
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

/// The supernodes of a range can be computed one after the other while others compute other ranges.
struct SupernodeRange {
  int begin = 0;
  int end = 0;
};

struct SymbolicFactor {
  std::vector<int> order;  ///< the column of M that is eliminated k-th
  std::vector<Supernode> supernodes;
  std::vector<int> rows;                   ///< of all supernodes, those of their columns first, ascending in each
  std::vector<std::vector<int>> children;  ///< of each supernode, ascending

  /// These ranges of supernodes do not depend on one another. Each is a set of whole subtrees. Behind them comes the
  /// rest, `top`, which needs all of them. The ranges are the same for any number of threads.
  std::vector<SupernodeRange> subtrees;
  SupernodeRange top;

  [[nodiscard]] int size() const noexcept { return static_cast<int>(order.size()); }
  /// Returns the rows below the triangle.
  [[nodiscard]] std::span<const int> rowsOf(const Supernode& supernode) const
  {
    return {rows.data() + supernode.firstRow + supernode.width, static_cast<std::size_t>(supernode.rowCount)};
  }
  /// Returns the supernode of a column. O(log supernodes).
  [[nodiscard]] int supernodeOf(int column) const;
  /// Returns the supernodes of these columns and all their ancestors, ascending.
  [[nodiscard]] std::vector<int> withAncestors(const std::vector<int>& columns) const;
  /// Returns the first column of `top`.
  [[nodiscard]] int topColumn() const;
  /// Returns how many entries of L are stored, those that supernodes add among them.
  [[nodiscard]] std::int64_t nonzeros() const;
  /// Returns how many floating-point operations the factorisation takes.
  [[nodiscard]] double flops() const;
  [[nodiscard]] bool hasMultipliers() const;
};

/// Returns how many floating-point operations a supernode with so many columns, and rows below them, takes.
[[nodiscard]] double flopsOf(double width, double rowCount);

/// Analyses the lower triangle `lower` for an order of elimination that keeps fill low. `order[k]` is the column that
/// comes k-th. Columns are reordered among those that are equally good. The call brings `lower` into the order of the
/// result. O(entries + rows of supernodes).
[[nodiscard]] SymbolicFactor analyze(SparseMatrix& lower, const std::vector<int>& order);

/// Finds all that follows from `lower`, the columns of supernodes and the ranges. `lower` is in the order of
/// elimination.
void complete(SymbolicFactor& factor, const SparseMatrix& lower);

}  // namespace holdfast
