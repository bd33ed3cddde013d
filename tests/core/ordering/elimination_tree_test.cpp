#include <numeric>

#include <gtest/gtest.h>

#include <holdfast/ordering/elimination_tree.h>

#include "core/factor/spd_matrices.h"

namespace holdfast {
namespace {

TEST(EliminationTree, AndLengthsOfColumnsAreThoseOfEliminationWrittenOut)
{
  test::Random random(3);
  for (int turn = 0; turn < 40; ++turn) {
    const Index n = random.integer(1, 60);
    const SparseMatrix M = test::randomSpd(random, n, random.integer(1, 4), random.integer(1, 3));
    std::vector<int> order(static_cast<std::size_t>(n));
    std::iota(order.begin(), order.end(), 0);
    for (Index k = n - 1; k > 0; --k) std::swap(order[k], order[random.integer(0, k)]);

    const SparseMatrix lower = inOrder(test::lowerOf(M), order);
    const std::vector<int> parent = eliminationTree(lower);
    const std::vector<int> counts = columnCounts(lower, parent, postorder(parent));
    const std::vector<std::set<int>> expected = test::factorPattern(M, order);
    for (Index k = 0; k < n; ++k) {
      EXPECT_EQ(parent[k], expected[k].empty() ? kNoParent : *expected[k].begin());
      EXPECT_EQ(counts[k], static_cast<int>(expected[k].size()) + 1);
    }
  }
}

TEST(EliminationTree, PostorderHasChildrenFirstAndSubtreesInOnePiece)
{
  //      6      2
  //     / \    |
  //    4   5   0
  //   / \.
  //  1   3
  const std::vector<int> parent{2, 4, kNoParent, 4, 6, 6, kNoParent};
  EXPECT_EQ(postorder(parent), (std::vector<int>{0, 2, 1, 3, 4, 5, 6}));
}

}  // namespace
}  // namespace holdfast
