#pragma once
/// What the pattern of a symmetric matrix says about its Cholesky factor: which columns depend on which, and how long
/// they are.

#include <vector>

#include <holdfast/base/types.h>

namespace holdfast {

inline constexpr int kNoParent = -1;

/// The lower triangle of P M P^T from that of M, where column `order[k]` of M comes k-th. The rows of a column are in
/// any order. O(entries).
[[nodiscard]] SparseMatrix inOrder(const SparseMatrix& lower, const std::vector<int>& order);

/// The elimination tree of the matrix with this lower triangle: of each column the first later one that its column of
/// the factor has an entry in (Liu, 1986).
[[nodiscard]] std::vector<int> eliminationTree(const SparseMatrix& lower);

/// The nodes of a forest, children before parents, each subtree in one piece.
[[nodiscard]] std::vector<int> postorder(const std::vector<int>& parent);

/// Entries of each column of the factor, its diagonal among them (Gilbert, Ng and Peyton, 1994). O(entries), nearly.
[[nodiscard]] std::vector<int> columnCounts(const SparseMatrix& lower, const std::vector<int>& parent,
                                            const std::vector<int>& post);

}  // namespace holdfast
