#include <limits>

#include <gtest/gtest.h>

#include <holdfast/base/no_subnormals_internal.h>
#include <holdfast/base/parallel.h>

namespace holdfast {
namespace {

double halfOfTheSmallest()
{
  volatile double smallest = std::numeric_limits<double>::min();
  return smallest / 2;
}

TEST(NoSubnormals, AreZeroOnThisThreadAndThoseItStartsUntilItEnds)
{
#ifndef __SSE2__
  GTEST_SKIP() << "this processor is left as it is";
#endif
  EXPECT_GT(halfOfTheSmallest(), 0);
  {
    const NoSubnormals arithmetic;
    parallelFor(64, [](Index) { EXPECT_EQ(halfOfTheSmallest(), 0); });
  }
  EXPECT_GT(halfOfTheSmallest(), 0);
}

}  // namespace
}  // namespace holdfast
