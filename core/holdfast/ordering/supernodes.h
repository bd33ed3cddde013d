#pragma once
/// Supernodes are columns of a Cholesky factor that are stored as one dense block.

#include <cstdint>
#include <vector>

namespace holdfast {

/// A draft holds columns that follow one another on a path of the elimination tree. They have nearly the same rows
/// below them.
struct SupernodeDraft {
  std::vector<int> columns;   ///< in the order that the tree was made in
  std::int64_t rowCount = 0;  ///< rows below all of them
  std::int64_t zeros = 0;     ///< stored entries that are none of the factor
  std::vector<int> children;  ///< drafts
};

/// Returns all supernodes, children before parents. Each is made of columns with the same rows below. Then children are
/// merged with their parents where that stores few zeros. Merged children have no columns left. The arguments are what
/// `eliminationTree`, `postorder` and `columnCounts` find. O(columns).
[[nodiscard]] std::vector<SupernodeDraft> supernodesOf(const std::vector<int>& parent, const std::vector<int>& post,
                                                       const std::vector<int>& count);

}  // namespace holdfast
