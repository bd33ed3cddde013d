#pragma once
/// The pattern of a symmetric matrix says which columns of its Cholesky factor depend on which, and how long they are.

#include <vector>

#include <holdfast/numbers/types.h>

namespace holdfast {

inline constexpr int kNoParent = -1;

/// Returns the lower triangle of P M P^T from that of M. Column `order[k]` of M comes k-th. The rows of a column are in
/// any order. O(entries).
[[nodiscard]] SparseMatrix inOrder(const SparseMatrix& lower, const std::vector<int>& order);

/// Returns the elimination tree of the matrix with this lower triangle (Liu, 1986). It has for each column the first
/// later one that its column of the factor has an entry in.
[[nodiscard]] std::vector<int> eliminationTree(const SparseMatrix& lower);

/// Returns the nodes of a forest, children before parents, each subtree in one piece.
[[nodiscard]] std::vector<int> postorder(const std::vector<int>& parent);

/// Returns how many entries each column of the factor has, its diagonal among them (Gilbert, Ng and Peyton, 1994).
/// O(entries), nearly.
[[nodiscard]] std::vector<int> columnCounts(const SparseMatrix& lower, const std::vector<int>& parent,
                                            const std::vector<int>& post);

}  // namespace holdfast
