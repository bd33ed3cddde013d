#include "holdfast/solve/elimination_order.h"

#include <algorithm>
#include <numeric>

#include <Eigen/OrderingMethods>

#include <holdfast/operators/laplacian.h>
#include <holdfast/solve/gram.h>

namespace holdfast {

std::vector<int> minimumDegreeOrder(const SparseMatrix& lower)
{
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
  Eigen::AMDOrdering<int>()(lower.selfadjointView<Eigen::Lower>(), order);
  return {order.indices().begin(), order.indices().end()};
}

std::vector<int> eliminationRanks(Index unknownCount, const std::vector<Triangle>& triangles)
{
  const TwoWayMatrix A(stiffness(unknownCount, unitEdgeWeights(triangles)));
  const std::vector<int> order = minimumDegreeOrder(gramLower(A));
  std::vector<int> ranks(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) ranks[order[k]] = static_cast<int>(k);
  return ranks;
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
  return assembled<SparseMatrix>(Q.rows(), Q.cols(), [&](Index k, ColumnSum& sum) {
    for (SparseMatrix::InnerIterator entry(Q, order[k]); entry; ++entry)
      sum.add(static_cast<int>(entry.row()), entry.value());
  });
}

}  // namespace holdfast
