#include <limits>

#include <gtest/gtest.h>

#include <holdfast/numbers/no_subnormals_internal.h>
#include <holdfast/threads/parallel.h>

namespace holdfast {
namespace {

double halfOfTheSmallest()
{
  volatile double smallest = std::numeric_limits<double>::min();
  return smallest / 2;
}

TEST(NoSubnormals, AreZeroOnThisThreadAndInItsLoopsUntilItEnds)
{
#ifndef __SSE2__
  GTEST_SKIP() << "this processor is left as it is";
#endif
  const auto areLeft = [] { parallelFor(64, [](Index) { EXPECT_GT(halfOfTheSmallest(), 0); }); };
  areLeft();
  {
    const NoSubnormals arithmetic;
    parallelFor(64, [](Index) { EXPECT_EQ(halfOfTheSmallest(), 0); });
  }
  areLeft();
}

}  // namespace
}  // namespace holdfast
