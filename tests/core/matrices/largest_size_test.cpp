#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <holdfast/matrices/largest_size.h>

namespace holdfast {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(LargestSize, FindsItInEveryRow)
{
  Columns3 x = Columns3::Constant(10'000, 3, -0.5);
  const Eigen::VectorXd scale = Eigen::VectorXd::Constant(x.rows(), -2);
  for (const Index row : {0, 4095, 4096, 9'999}) {
    x(row, row % 3) = -3;
    EXPECT_EQ(largestSize(x), 3) << row;
    EXPECT_EQ(largestSize(scale, x), 6) << row;
    x(row, row % 3) = -0.5;
  }
  EXPECT_EQ(largestSize(x), 0.5);
  EXPECT_EQ(largestSize(Columns3(0, 3)), 0);
}

TEST(LargestSize, IsNoNumberWhereAnEntryIsNone)
{
  for (const Index row : {0, 5'000, 9'999}) {
    Columns3 x = Columns3::Constant(10'000, 3, 1);
    x(row, 1) = kNaN;
    EXPECT_TRUE(std::isnan(largestSize(x))) << row;
    x(row, 1) = -std::numeric_limits<double>::infinity();
    EXPECT_TRUE(std::isinf(largestSize(x))) << row;
  }
}

}  // namespace
}  // namespace holdfast
