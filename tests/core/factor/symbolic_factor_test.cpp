#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

#include <holdfast/factor/symbolic_factor.h>

#include "core/factor/spd_matrices.h"

namespace holdfast {
namespace {

std::vector<int> identity(Index n)
{
  std::vector<int> order(static_cast<std::size_t>(n));
  std::iota(order.begin(), order.end(), 0);
  return order;
}

TEST(SymbolicFactor, StoresEveryEntryOfTheFactor)
{
  test::Random random(5);
  for (int turn = 0; turn < 30; ++turn) {
    const SparseMatrix M = test::randomSpd(random, random.integer(1, 150), random.integer(1, 4), random.integer(1, 3));
    SparseMatrix lower = test::lowerOf(M);
    const SymbolicFactor factor = analyze(lower, identity(M.cols()));
    const std::vector<std::set<int>> expected = test::factorPattern(M, factor.order);
    int column = 0;
    for (const Supernode& node : factor.supernodes) {
      ASSERT_EQ(node.firstColumn, column);
      const auto rows = factor.rowsOf(node);
      EXPECT_TRUE(std::is_sorted(rows.begin(), rows.end()));
      for (; column < node.firstColumn + node.width; ++column)
        for (const int row : expected[column])
          EXPECT_TRUE(row < node.firstColumn + node.width || std::binary_search(rows.begin(), rows.end(), row));
    }
    EXPECT_EQ(column, M.cols());
  }
}

TEST(SymbolicFactor, SubtreesDependOnNothingOutsideThemselves)
{
  SparseMatrix lower = test::lowerOf(test::gridMatrix(12));
  const SymbolicFactor factor = analyze(lower, test::minimumDegree(lower));
  ASSERT_GT(factor.subtrees.size(), 1);
  ASSERT_LT(factor.top.begin, factor.top.end);
  for (const SupernodeRange& range : factor.subtrees)
    for (int s = range.begin; s < range.end; ++s) {
      const int parent = factor.supernodes[s].parent;
      EXPECT_GT(parent, s);
      EXPECT_TRUE(parent < range.end || parent >= factor.top.begin);
    }
}

TEST(SymbolicFactor, AnOrderOfTheMatrixIsKeptWhereColumnsAreNotEquallyGood)
{
  // A chain from one end to the other has no fill, whatever is merged.
  std::vector<Eigen::Triplet<double, int>> entries;
  constexpr int n = 500;
  for (int i = 0; i < n; ++i) {
    entries.emplace_back(i, i, 3);
    if (i > 0) entries.emplace_back(i, i - 1, -1);
  }
  SparseMatrix lower(n, n);
  lower.setFromTriplets(entries.begin(), entries.end());
  EXPECT_EQ(analyze(lower, identity(n)).order, identity(n));
}

}  // namespace
}  // namespace holdfast
