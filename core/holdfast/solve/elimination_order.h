#pragma once
/// The order in which a factorisation eliminates unknowns, found once for a mesh and kept across sets of constraints.

#include <vector>

#include <holdfast/mesh/triangulation.h>

namespace holdfast {

/// Minimum degree (AMD; Amestoy, Davis, Duff, 1996) for the symmetric matrix whose lower triangle is given: the column
/// that is eliminated k-th.
[[nodiscard]] std::vector<int> minimumDegreeOrder(const SparseMatrix& lower);

enum class OrderFor { FirstResult, ManyResults };

/// Of each unknown: its place in an order that keeps factors of A^T A small, A having an entry for each edge of
/// `triangles` and each unknown. Constraints take unknowns away, which never adds fill.
struct EliminationRanks {
  std::vector<int> ranks;
  bool isByDissection = false;
};

/// By minimum degree. By METIS, where it is built in and leaves less to compute: for many results always, for the first
/// one from 300,000 unknowns on, where minimum degree leaves so much that both together are less.
[[nodiscard]] EliminationRanks eliminationRanks(Index unknownCount, const std::vector<Triangle>& triangles,
                                                OrderFor use = OrderFor::FirstResult);

/// Q (n x k) with its columns by the last of their unknowns: a column ties together what its unknowns are tied to, and
/// goes with them where that adds least fill. Any order of columns where `ranks` is empty.
[[nodiscard]] SparseMatrix orderedColumns(const SparseMatrix& Q, const std::vector<int>& ranks);

}  // namespace holdfast
