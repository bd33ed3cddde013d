#pragma once
/// Columns of a Cholesky factor that are stored as one dense block.

#include <cstdint>
#include <vector>

namespace holdfast {

/// Columns one after the other on a path of the elimination tree, with nearly the same rows below them.
struct SupernodeDraft {
  std::vector<int> columns;   ///< in the order that the tree was made in
  std::int64_t rowCount = 0;  ///< rows below all of them
  std::int64_t zeros = 0;     ///< stored entries that are none of the factor
  std::vector<int> children;  ///< drafts
};

/// All of them, children before parents: columns with the same rows below, and then children merged with their parents
/// where that stores few zeros. Merged children have no columns left. Takes what `eliminationTree`, `postorder` and
/// `columnCounts` find. O(columns).
[[nodiscard]] std::vector<SupernodeDraft> supernodesOf(const std::vector<int>& parent, const std::vector<int>& post,
                                                       const std::vector<int>& count);

}  // namespace holdfast
