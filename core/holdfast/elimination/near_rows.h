#pragma once
/// Rows of a large basis that nearly depend on the others.

#include <vector>

#include <holdfast/elimination/dependency.h>

namespace holdfast {

/// Rows that nearly depend on others.
struct NearRows {
  std::vector<Index> last;     ///< the rows to be taken away
  bool isBeyondOrder = false;  ///< over `kLargestCluster` nearly depend on one another: `last` has just any half
};

inline constexpr std::size_t kLargestCluster = 512;

/// Returns the rows without which no row of `basis` is closer than `tolerance` to the span of others. One look may not
/// find all. Of rows that nearly depend on one another these are the last ones in the order of `basis`. One sparse QR
/// is made, and then a dense one for each cluster of close rows.
[[nodiscard]] NearRows nearlyDependentRows(const std::vector<RowTerms>& rows, const std::vector<Index>& basis,
                                           const std::vector<Index>& unknowns, double tolerance);

}  // namespace holdfast
