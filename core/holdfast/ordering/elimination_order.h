#pragma once
/// The order in which a factorisation eliminates unknowns, found once for a mesh and kept across sets of constraints.

#include <vector>

#include <holdfast/mesh/triangulation.h>

namespace holdfast {

/// Of each unknown: its place in an order that keeps factors of A^T A small, A having an entry for each edge of
/// `triangles` and each unknown. By nested dissection. Constraints take unknowns away, which never adds fill.
[[nodiscard]] std::vector<int> eliminationRanks(Index unknownCount, const std::vector<Triangle>& triangles);

/// The places of `keys`, -1 to `end` - 1, by ascending key, and where keys are equal as they are. O(keys + end).
[[nodiscard]] std::vector<int> ascending(const std::vector<int>& keys, int end);

/// Q (n x k) with its columns by the last of their unknowns: a column ties together what its unknowns are tied to, and
/// goes with them where that adds least fill. Any order of columns where `ranks` is empty.
[[nodiscard]] SparseMatrix orderedColumns(const SparseMatrix& Q, const std::vector<int>& ranks);

}  // namespace holdfast
