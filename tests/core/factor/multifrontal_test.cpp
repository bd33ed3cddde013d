#include <algorithm>
#include <future>
#include <memory>

#include <Eigen/Dense>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/factor/multifrontal.h>
#include <holdfast/memory/available_memory.h>
#include <holdfast/threads/long_step.h>

#include "core/factor/spd_matrices.h"
#include "support/latch.h"
#include "support/one_core.h"

namespace holdfast {
namespace {

using testing::EndsWith;
using testing::StartsWith;

auto factorized(const test::Analysis& analysis)
{
  return factorizeMultifrontal(analysis.symbolic, analysis.lower);
}

TEST(Multifrontal, SolvesAsDenseEliminationDoes)
{
  test::Random random(7);
  for (int turn = 0; turn < 40; ++turn) {
    const SparseMatrix M = test::randomSpd(random, random.integer(1, 300), random.integer(0, 6), random.integer(1, 4));
    const auto result = factorized(test::Analysis(M));
    ASSERT_TRUE(result) << result.failure;
    const Columns3 expected = Columns3::Random(M.cols(), 3);
    const Columns3 found = test::solved(*result.value, M * expected);
    EXPECT_LT((found - expected).cwiseAbs().maxCoeff(), 1e-13);
  }
}

TEST(Multifrontal, SolvesWithFrontsOfManyBlocks)
{
  const SparseMatrix M = test::gridMatrix(22);
  const test::Analysis analysis(M);
  EXPECT_TRUE(
      std::ranges::any_of(analysis.symbolic->supernodes, [](const Supernode& node) { return node.width > 400; }));
  const auto result = factorized(analysis);
  ASSERT_TRUE(result) << result.failure;
  const Columns3 expected = Columns3::Random(M.cols(), 3);
  EXPECT_LT((test::solved(*result.value, M * expected) - expected).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(Multifrontal, TellsItsShareOfOperations)
{
  LongStep<double> step([&] {
    EXPECT_TRUE(factorized(test::Analysis(test::gridMatrix(8))));
    return currentStep()->share();
  });
  EXPECT_NEAR(step.result(noProgress()), 1, 1e-12);
}

TEST(Multifrontal, RefusesAFactorThatIsLargerThanMemory)
{
  SymbolicFactor large;
  constexpr int kSize = 20'000'000;  // 1.6 PB of one triangle
  large.supernodes.push_back({0, kSize});
  large.children.resize(1);
  large.order.resize(kSize);
  try {
    static_cast<void>(factorizeMultifrontal(std::make_shared<const SymbolicFactor>(large), SparseMatrix()));
    FAIL() << "takes 1.6 PB";
  } catch (const LackOfMemory& lack) {
    EXPECT_THAT(lack.what(), StartsWith("the factor of 20000000 unknowns needs 1600000.1 GB of memory and "));
    EXPECT_THAT(lack.what(), EndsWith(" GB are free; close other programs, or take a coarser mesh"));
  }
}

TEST(Multifrontal, HasTheSameBitsOnOneCore)
{
  const SparseMatrix M = test::gridMatrix(16);
  const test::Analysis analysis(M);
  ASSERT_GT(analysis.symbolic->subtrees.size(), 1);
  const Columns3 b = Columns3::Random(M.cols(), 3);
  const Columns3 onAll = test::solved(*factorized(analysis).value, b);
  const test::OneCore one;
  EXPECT_EQ(test::solved(*factorized(analysis).value, b), onAll);
}

TEST(Multifrontal, EndsWhereNobodyWaits)
{
  const test::Analysis analysis(test::gridMatrix(8));
  const auto begun = std::make_shared<test::Latch>();
  const auto left = std::make_shared<test::Latch>();
  const auto isGivenUp = std::make_shared<std::promise<bool>>();
  std::future<bool> end = isGivenUp->get_future();
  {
    LongStep<int> step([=] {
      begun->open();
      EXPECT_TRUE(left->wait());
      try {
        static_cast<void>(factorized(analysis));
        isGivenUp->set_value(false);
      } catch (const LeftBehind&) {
        isGivenUp->set_value(true);
      }
      return 0;
    });
    step.start(noProgress());
    EXPECT_TRUE(begun->wait());
  }
  left->open();
  EXPECT_TRUE(end.get());
}

TEST(Multifrontal, NamesThePivotThatIsNotPositive)
{
  test::Analysis analysis(test::gridMatrix(8));
  for (SparseMatrix::InnerIterator entry(analysis.lower, 300); entry; ++entry)
    if (entry.row() == 300) entry.valueRef() = -1;
  const auto result = factorized(analysis);
  EXPECT_EQ(result.value, nullptr);
  EXPECT_EQ(result.failure, "the normal equations are not positive definite in doubles (pivot 301 of 512)");
}

}  // namespace
}  // namespace holdfast
