#pragma once
/// Rows of a large basis that nearly depend on the others.

#include <vector>

#include <holdfast/elimination/dependency.h>

namespace holdfast {

/// Rows that nearly depend on others.
struct NearRows {
  std::vector<Index> last;     ///< those to be taken away
  bool isBeyondOrder = false;  ///< more than `kLargestCluster` nearly depend on one another: of these just any half
};

inline constexpr std::size_t kLargestCluster = 512;

/// Rows without which no row of `basis` is closer than `tolerance` to the span of others, as far as one look tells: of
/// those that nearly depend on one another, the last ones in the order of `basis`. One sparse QR; then each cluster of
/// close rows takes a dense one of its own.
[[nodiscard]] NearRows nearlyDependentRows(const std::vector<RowTerms>& rows, const std::vector<Index>& basis,
                                           const std::vector<Index>& unknowns, double tolerance);

}  // namespace holdfast
