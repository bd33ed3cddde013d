#include "holdfast/solve/elimination_order.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include <Eigen/OrderingMethods>

#include <holdfast/base/sparse_products.h>
#include <holdfast/factor/elimination_tree.h>
#include <holdfast/operators/laplacian.h>
#include <holdfast/solve/nested_dissection_internal.h>

namespace holdfast {

#ifdef HOLDFAST_WITH_CHOLMOD
namespace {

// A mesh of this size takes METIS two seconds, and minimum degree another tenth of one to count what it leaves to do.
constexpr Index kLargeMesh = 300000;
// Flops of a factorisation for each unknown, from which on METIS wins more than it takes.
constexpr double kManyFlops = 600000;

/// Flops of a Cholesky factorisation in this order.
double flopsOf(const SparseMatrix& lower, const std::vector<int>& order)
{
  const OrderedPattern pattern = orderedPattern(lower, order);
  const std::vector<int> parent = eliminationTree(pattern);
  double flops = 0;
  for (const int count : columnCounts(pattern, parent, postorder(parent)))
    flops += static_cast<double>(count) * static_cast<double>(count);
  return flops;
}

}  // namespace
#endif

std::vector<int> minimumDegreeOrder(const SparseMatrix& lower)
{
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
  Eigen::AMDOrdering<int>()(lower.selfadjointView<Eigen::Lower>(), order);
  return {order.indices().begin(), order.indices().end()};
}

EliminationRanks eliminationRanks(Index unknownCount, const std::vector<Triangle>& triangles,
                                  [[maybe_unused]] OrderFor use)
{
  const TwoWayMatrix A(stiffness(unknownCount, unitEdgeWeights(triangles)));
  const SparseMatrix lower = gramLower(A);
  const std::vector<int> order = minimumDegreeOrder(lower);
#ifdef HOLDFAST_WITH_CHOLMOD
  if (use == OrderFor::ManyResults || unknownCount >= kLargeMesh) {
    const double flops = flopsOf(lower, order);
    if (use == OrderFor::ManyResults || flops > kManyFlops * static_cast<double>(unknownCount))
      if (const std::vector<int> other = nestedDissectionOrder(lower); !other.empty() && flopsOf(lower, other) < flops)
        return {inverse(other), true};
  }
#endif
  return {inverse(order)};
}

SparseMatrix orderedColumns(const SparseMatrix& Q, const std::vector<int>& ranks)
{
  if (ranks.empty()) return Q;
  std::vector<int> last(static_cast<std::size_t>(Q.cols()), -1);
  for (Index k = 0; k < Q.cols(); ++k)
    for (SparseMatrix::InnerIterator entry(Q, k); entry; ++entry) last[k] = std::max(last[k], ranks[entry.row()]);
  std::vector<int> order(last.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](int k) { return last[k]; });
  return assembled<SparseMatrix>(Q.rows(), Q.cols(), [&](Index k, ColumnSum& sum) { sum.addColumn(Q, order[k]); });
}

}  // namespace holdfast
