#pragma once
/// What the pattern of a symmetric matrix says about its Cholesky factor: which columns depend on which, and how long
/// they are.

#include <vector>

#include <holdfast/base/types.h>

namespace holdfast {

inline constexpr int kNoParent = -1;

/// The strict lower triangle of a symmetric matrix whose columns are eliminated in some order: for each place in that
/// order, the later places that it is tied to.
struct OrderedPattern {
  std::vector<int> start;   ///< n + 1
  std::vector<int> row;     ///< a place, greater than that of the column
  std::vector<int> source;  ///< of each entry: where its value is stored in the matrix

  [[nodiscard]] int size() const noexcept { return static_cast<int>(start.size()) - 1; }
};

/// The pattern of `lower` (the lower triangle of a matrix) where column `order[k]` is eliminated k-th. O(entries).
[[nodiscard]] OrderedPattern orderedPattern(const SparseMatrix& lower, const std::vector<int>& order);

/// The elimination tree: of each column the first later one that its column of the factor has an entry in (Liu, 1986).
[[nodiscard]] std::vector<int> eliminationTree(const OrderedPattern& pattern);

/// The nodes of a forest, children before parents, each subtree in one piece.
[[nodiscard]] std::vector<int> postorder(const std::vector<int>& parent);

/// Entries of each column of the factor, its diagonal among them (Gilbert, Ng and Peyton, 1994). O(entries), nearly.
[[nodiscard]] std::vector<int> columnCounts(const OrderedPattern& pattern, const std::vector<int>& parent,
                                            const std::vector<int>& post);

/// The place of each element of a permutation.
[[nodiscard]] std::vector<int> inverse(const std::vector<int>& permutation);

}  // namespace holdfast
