#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include <holdfast/widgets/color/histogram.h>

#include "support/random.h"
#include "support/special_values.h"

namespace holdfast {
namespace {

using Counts = std::vector<Index>;
using Edges = std::vector<double>;

TEST(Histogram, EveryValueIsInTheBinWhoseEndsHoldIt)
{
  test::Random random(7);
  std::vector<double> values;
  for (int k = 0; k < 2000; ++k) values.push_back(random.uniform(-3, 17));
  const Histogram histogram = linearHistogram(values, TickSteps::Decimal, 20);
  Counts expected(histogram.counts.size(), 0);
  for (const double value : values)
    for (std::size_t bin = 0; bin < expected.size(); ++bin)
      if (value >= histogram.edges[bin] && value < histogram.edges[bin + 1]) ++expected[bin];
  EXPECT_EQ(histogram.counts, expected);
  EXPECT_EQ(histogram.valueCount, 2000);
  EXPECT_LE(histogram.counts.size(), 20U);
}

TEST(Histogram, BinsEndAtRoundNumbers)
{
  const std::vector<double> values{0, 0.31, 3.7};
  EXPECT_EQ(linearHistogram(values, TickSteps::Decimal, 5).edges, (Edges{0, 1, 2, 3, 4}));
  const std::vector<double> turns{0, 100, 360};
  EXPECT_EQ(linearHistogram(turns, TickSteps::Degrees, 9).edges, (Edges{0, 45, 90, 135, 180, 225, 270, 315, 360}));
}

TEST(Histogram, TheLargestValueIsInTheLastBin)
{
  const std::vector<double> turns{0, 359, 360, 360};
  const Histogram histogram = linearHistogram(turns, TickSteps::Degrees, 9);
  EXPECT_EQ(histogram.counts, (Counts{1, 0, 0, 0, 0, 0, 0, 3}));
}

TEST(Histogram, ValuesThatAreAllTheSameHaveABin)
{
  for (const double value : {0.0, 90.0, -1e-30, 1e30}) {
    const std::vector<double> values(7, value);
    const Histogram histogram = linearHistogram(values, TickSteps::Decimal, 12);
    EXPECT_EQ(histogram.counts[binOf(histogram, value).value()], 7) << value;
    EXPECT_LE(histogram.counts.size(), 12U) << value;
  }
}

TEST(Histogram, ValuesThatHardlyDifferEnd)
{
  const std::vector<double> values{1e17, 1e17 + 16};
  EXPECT_EQ(linearHistogram(values, TickSteps::Decimal, 20).valueCount, 2);
}

TEST(Histogram, WhatIsNoNumberIsLeftOut)
{
  const std::vector<double> values{test::kNan, 1, test::kInfinity, 2, -test::kInfinity, test::kNan};
  for (const Histogram& histogram :
       {linearHistogram(values, TickSteps::Decimal, 4), logarithmicHistogram(values, -3, 1)}) {
    EXPECT_EQ(histogram.valueCount, 2);
    EXPECT_FALSE(binOf(histogram, test::kNan));
    EXPECT_FALSE(binOf(histogram, test::kInfinity));
  }
}

TEST(Histogram, WithoutAValueThereIsNothing)
{
  const std::vector<double> values{test::kNan};
  const Histogram histogram = linearHistogram(values, TickSteps::Decimal, 4);
  EXPECT_TRUE(histogram.counts.empty());
  EXPECT_TRUE(edgeTicks(histogram, 5).empty());
  EXPECT_EQ(placeAmongBins(histogram, 3), 0);
}

TEST(Histogram, AllThatIsTinyIsInTheFirstLogarithmicBin)
{
  const std::vector<double> values{0, 1e-300, 9.9e-18, 1e-17, 2e-13, 5e-12};
  const Histogram histogram = logarithmicHistogram(values, -17, -11);
  EXPECT_EQ(histogram.counts, (Counts{3, 1, 0, 0, 0, 1, 1}));
  EXPECT_EQ(histogram.edges.front(), 0);
  EXPECT_EQ(histogram.edges.back(), 1e-11);
}

TEST(Histogram, LargeValuesAddPowersOfTen)
{
  const std::vector<double> values{0.25};
  const Histogram histogram = logarithmicHistogram(values, -17, -11);
  EXPECT_EQ(histogram.edges.back(), 1);
  EXPECT_EQ(histogram.counts.back(), 1);
}

TEST(Histogram, PlacesInABinAreThoseOfItsValues)
{
  const std::vector<double> values{0.5, 2.5, test::kNan, 0.25, 3};
  const Histogram histogram = linearHistogram(values, TickSteps::Decimal, 4);
  EXPECT_EQ(placesInBin(histogram, values, 0), (Counts{0, 3}));
  EXPECT_EQ(placesInBin(histogram, values, 2), (Counts{1, 4}));
}

TEST(Histogram, PlacesAmongBinsAreThoseOfTheScale)
{
  const std::vector<double> values{0, 4};
  const Histogram linear = linearHistogram(values, TickSteps::Decimal, 5);
  EXPECT_EQ(placeAmongBins(linear, 2.5), 2.5);
  EXPECT_EQ(placeAmongBins(linear, 100), 4);
  const Histogram logarithmic = logarithmicHistogram({}, -17, -11);
  EXPECT_NEAR(placeAmongBins(logarithmic, 1e-12), 6, 1e-12);
  EXPECT_NEAR(placeAmongBins(logarithmic, std::sqrt(10) * 1e-12), 6.5, 1e-12);
}

TEST(Histogram, TicksNameEdgesAndRoundCounts)
{
  const auto ticks = edgeTicks(logarithmicHistogram({}, -17, -11), 10);
  ASSERT_EQ(ticks.size(), 8);
  EXPECT_EQ(ticks[0].text, "0");
  EXPECT_EQ(ticks[1].text, "1e-17");
  EXPECT_EQ(ticks[1].value, 1);
  EXPECT_EQ(countTicks(3).size(), 4U);
  EXPECT_EQ(countTicks(1234).back().text, "1000");
  EXPECT_EQ(countTicks(0).size(), 2U);
}

}  // namespace
}  // namespace holdfast
