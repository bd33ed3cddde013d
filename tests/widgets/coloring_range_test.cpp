
#include <gtest/gtest.h>

#include <holdfast/widgets/color/coloring.h>

#include "support/special_values.h"

namespace holdfast {
namespace {

Coloring sample()
{
  return {{0, test::kNan, 0.02, 37}, {"lengths", Scaling::Linear, 0, 37}};
}

TEST(ColoringRange, AutomaticIsWhatItWas)
{
  const Coloring coloring = withRange(sample(), AutomaticRange{});
  EXPECT_EQ(coloring.scale.low, 0);
  EXPECT_EQ(coloring.scale.high, 37);
  EXPECT_EQ(coloring.scale.title, "lengths");
}

TEST(ColoringRange, FixedEndsAreTaken)
{
  const Coloring coloring = withRange(sample(), FixedRange{-5, 10});
  EXPECT_EQ(colorOf(coloring.scale, 2.5), mapColor(0.5));
  EXPECT_EQ(colorOf(coloring.scale, 10), mapColor(1));
  EXPECT_EQ(colorOf(coloring.scale, coloring.values[3]), kBeyondColor);
  EXPECT_EQ(colorOf(coloring.scale, coloring.values[1]), kNoValueColor);
}

TEST(ColoringRange, FixedStaysLogarithmicWhereItCan)
{
  Coloring residuals = sample();
  residuals.scale = {"residual", Scaling::Logarithmic, 1e-15, 1e-9};
  EXPECT_EQ(withRange(residuals, FixedRange{1e-12, 1e-6}).scale.scaling, Scaling::Logarithmic);
  EXPECT_EQ(withRange(residuals, FixedRange{0, 1e-6}).scale.scaling, Scaling::Linear);
}

TEST(ColoringRange, LogarithmicIsDecadesBelowTheLargest)
{
  const Coloring coloring = withRange(sample(), LogarithmicRange{3});
  EXPECT_EQ(coloring.scale.scaling, Scaling::Logarithmic);
  EXPECT_DOUBLE_EQ(coloring.scale.low, 0.1);
  EXPECT_DOUBLE_EQ(coloring.scale.high, 100);
  EXPECT_EQ(shareOf(coloring.scale, 0), 0);
}

TEST(ColoringRange, LogarithmicNeedsAValueAboveZero)
{
  for (const double value : {0.0, -3.0, test::kNan, test::kInfinity, 5e-324}) {
    const Coloring coloring = withRange({{value}, {"", Scaling::Linear, -4, 1}}, LogarithmicRange{4});
    EXPECT_EQ(coloring.scale.scaling, Scaling::Linear) << value;
    EXPECT_EQ(coloring.scale.low, -4) << value;
  }
}

TEST(ColoringRange, ValuesStayBitForBit)
{
  Coloring coloring = sample();
  coloring.values[1] = 0.1;
  for (const ColorRange& range : {ColorRange{FixedRange{1, 2}}, ColorRange{LogarithmicRange{2}}})
    EXPECT_EQ(withRange(coloring, range).values, coloring.values);
}

TEST(ColoringRange, ImpossibleOnesAreNamed)
{
  EXPECT_EQ(whyNoRange(AutomaticRange{}), "");
  EXPECT_EQ(whyNoRange(FixedRange{1, 2}), "");
  EXPECT_NE(whyNoRange(FixedRange{2, 2}), "");
  EXPECT_NE(whyNoRange(FixedRange{test::kNan, 2}), "");
  EXPECT_NE(whyNoRange(FixedRange{-1.7e308, 1.7e308}), "");
  EXPECT_EQ(whyNoRange(LogarithmicRange{1}), "");
  EXPECT_NE(whyNoRange(LogarithmicRange{0}), "");
}

}  // namespace
}  // namespace holdfast
