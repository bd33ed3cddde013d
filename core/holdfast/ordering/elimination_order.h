#pragma once
/// A factorisation eliminates unknowns in an order that is found once for a mesh and kept across sets of constraints.

#include <vector>

#include <holdfast/mesh/triangulation.h>

namespace holdfast {

/// Returns the place of each unknown in an order that keeps factors of A^T A small. It finds the order by nested
/// dissection. A has an entry for each edge of `triangles` and for each unknown. Constraints take unknowns away, which
/// never adds fill.
[[nodiscard]] std::vector<int> eliminationRanks(Index unknownCount, const std::vector<Triangle>& triangles);

/// Returns the places of `keys` by ascending key. Places of equal keys stay in their order. Keys are -1 to `end` - 1.
/// O(keys + end).
[[nodiscard]] std::vector<int> ascending(const std::vector<int>& keys, int end);

/// Returns Q (n x k) with its columns in the order of the last of their unknowns. A column ties together what its
/// unknowns are tied to. It goes with the last of them, where that adds least fill. Where `ranks` is empty, columns may
/// be in any order.
[[nodiscard]] SparseMatrix orderedColumns(const SparseMatrix& Q, const std::vector<int>& ranks);

}  // namespace holdfast
