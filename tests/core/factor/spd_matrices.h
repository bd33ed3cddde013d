#pragma once
/// \file
/// Symmetric positive definite matrices to factorise, and what is known of their factors.

#include <algorithm>
#include <set>
#include <vector>

#include <Eigen/OrderingMethods>

#include <holdfast/factor/packed_factor.h>

#include "support/random.h"

namespace holdfast::test {

/// Diagonally dominant, with about `ties` entries a row off the diagonal, in `pieces` that are not tied to one another.
inline SparseMatrix randomSpd(Random& random, Index n, Index ties, Index pieces = 1)
{
  std::vector<Eigen::Triplet<double, Index>> entries;
  for (Index i = 0; i < n; ++i) entries.emplace_back(i, i, 1);
  for (Index k = 0; k < n * ties / 2; ++k) {
    const Index i = random.integer(0, n - 1);
    const Index j = random.integer(0, n - 1);
    if (i == j || i % pieces != j % pieces) continue;
    const double value = random.uniform(-1, 1);
    entries.emplace_back(i, j, value);
    entries.emplace_back(j, i, value);
  }
  SparseMatrix M(n, n);
  M.setFromTriplets(entries.begin(), entries.end());
  for (Index i = 0; i < n; ++i) M.coeffRef(i, i) += M.col(i).cwiseAbs().sum();
  return M;
}

inline SparseMatrix lowerOf(const SparseMatrix& M)
{
  return M.triangularView<Eigen::Lower>();
}

/// The Laplacian of a grid of n x n x n points, plus the identity.
inline SparseMatrix gridMatrix(int n)
{
  std::vector<Eigen::Triplet<double, int>> entries;
  const int count = n * n * n;
  for (int i = 0; i < count; ++i) {
    entries.emplace_back(i, i, 7);
    for (const int step : {1, n, n * n})
      if (i / step % n + 1 < n) {
        entries.emplace_back(i, i + step, -1);
        entries.emplace_back(i + step, i, -1);
      }
  }
  SparseMatrix M(count, count);
  M.setFromTriplets(entries.begin(), entries.end());
  return M;
}

/// An order of elimination with little fill and many subtrees.
inline std::vector<int> minimumDegree(const SparseMatrix& lower)
{
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
  Eigen::AMDOrdering<int>()(lower.selfadjointView<Eigen::Lower>(), order);
  return {order.indices().begin(), order.indices().end()};
}

/// The rows below the diagonal of each column of the factor of P M P^T, by elimination written out: eliminating a
/// column ties all that it is tied to.
inline std::vector<std::set<int>> factorPattern(const SparseMatrix& M, const std::vector<int>& order)
{
  std::vector<int> place(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) place[order[k]] = static_cast<int>(k);
  std::vector<std::set<int>> columns(order.size());
  for (int j = 0; j < M.cols(); ++j)
    for (SparseMatrix::InnerIterator entry(M, j); entry; ++entry)
      if (place[entry.row()] > place[j]) columns[place[j]].insert(place[entry.row()]);
  for (std::set<int>& column : columns)
    if (!column.empty()) columns[*column.begin()].insert(std::next(column.begin()), column.end());
  return columns;
}

/// The lower triangle of M in an order of elimination, and the structure of its factor.
struct Analysis {
  SparseMatrix lower;
  std::shared_ptr<const SymbolicFactor> symbolic;

  explicit Analysis(const SparseMatrix& M)
      : lower(lowerOf(M)), symbolic(std::make_shared<const SymbolicFactor>(analyze(lower, minimumDegree(lower))))
  {
  }
};

/// What the factor makes of b, in the order of the matrix.
inline Columns3 solved(const PackedFactor& factor, const Columns3& b)
{
  const std::vector<int>& order = factor.symbolic().order;
  std::vector<double> x(4 * order.size());
  for (std::size_t k = 0; k < order.size(); ++k)
    for (int c = 0; c < 3; ++c) x[4 * k + static_cast<std::size_t>(c)] = b(order[k], c);
  factor.solveForward(x);
  factor.solveBackward(x);
  Columns3 z(b.rows(), 3);
  for (std::size_t k = 0; k < order.size(); ++k)
    for (int c = 0; c < 3; ++c) z(order[k], c) = x[4 * k + static_cast<std::size_t>(c)];
  return z;
}

}  // namespace holdfast::test
