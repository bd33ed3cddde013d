#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include <gtest/gtest.h>
#include <vtkLookupTable.h>

#include <holdfast/view/color_map.h>
#include <holdfast/view/scalar_legend.h>

namespace holdfast {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr int kSteps = 500;

double distance(const LabColor& p, const LabColor& q)
{
  return std::hypot(p.lightness - q.lightness, p.a - q.a, p.b - q.b);
}

LabColor labAt(int step)
{
  return toLab(mapColor(step / static_cast<double>(kSteps)));
}

TEST(ColorMap, LabOfKnownColorsIsKnown)
{
  const LabColor white = toLab({1, 1, 1});
  EXPECT_NEAR(white.lightness, 100, 1e-3);
  EXPECT_NEAR(std::hypot(white.a, white.b), 0, 0.02);
  // sRGB red under D65, as tabulated.
  EXPECT_NEAR(distance(toLab({1, 0, 0}), {53.24, 80.09, 67.20}), 0, 0.05);
}

TEST(ColorMap, LightnessRisesAllTheWay)
{
  for (int k = 0; k < kSteps; ++k) EXPECT_LT(labAt(k).lightness, labAt(k + 1).lightness) << "step " << k;
}

TEST(ColorMap, EqualStepsLookAboutEqual)
{
  double length = 0;
  for (int k = 0; k < kSteps; ++k) length += distance(labAt(k), labAt(k + 1));
  // Control points are rounded to whole units of Lab and stand 16 to 20 apart.
  for (int k = 0; k < kSteps; ++k)
    EXPECT_NEAR(distance(labAt(k), labAt(k + 1)) * kSteps / length, 1, 0.2) << "step " << k;
}

TEST(ColorMap, BlueToYellowSetsTheEndsApartWithoutRedAndGreen)
{
  EXPECT_LT(labAt(0).b, -40);
  EXPECT_GT(labAt(kSteps).b, 60);
}

TEST(ColorMap, NoValueIsAGreyThatTheMapDoesNotHave)
{
  EXPECT_EQ(mapColor(kNan), kNoValueColor);
  for (int k = 0; k <= kSteps; ++k) EXPECT_GT(distance(labAt(k), toLab(kNoValueColor)), 25) << "step " << k;
}

TEST(ColorMap, TableOfVtkHasTheSameColors)
{
  const auto table = toLookupTable();
  for (int k = 0; k <= kSteps; ++k) {
    const double share = k / static_cast<double>(kSteps);
    const Color color = mapColor(share);
    const unsigned char* const drawn = table->MapValue(share);
    EXPECT_NEAR(drawn[0], 255 * color.red, 1) << share;
    EXPECT_NEAR(drawn[1], 255 * color.green, 1) << share;
    EXPECT_NEAR(drawn[2], 255 * color.blue, 1) << share;
  }
}

TEST(ColorScale, EndsAndMiddleOfALinearScale)
{
  const ColorScale scale{"", Scaling::Linear, 2, 6, {}};
  EXPECT_EQ(shareOf(scale, 2), 0);
  EXPECT_EQ(shareOf(scale, 4), 0.5);
  EXPECT_EQ(shareOf(scale, 6), 1);
  EXPECT_EQ(colorOf(scale, 4), mapColor(0.5));
}

TEST(ColorScale, ValuesBeyondTheEndsTakeTheirColors)
{
  const ColorScale scale{"", Scaling::Logarithmic, 1e-15, 1e-5, {}};
  EXPECT_EQ(shareOf(scale, 0), 0);
  EXPECT_NEAR(shareOf(scale, 1e-10), 0.5, 1e-12);
  EXPECT_EQ(shareOf(scale, std::numeric_limits<double>::infinity()), 1);
  EXPECT_TRUE(std::isnan(shareOf(scale, kNan)));
}

TEST(LegendTicks, AreRoundAndInside)
{
  const auto ticks = ticksOf({"", Scaling::Linear, 0, 4.37, {}});
  ASSERT_EQ(ticks.size(), 5);
  EXPECT_EQ(ticks.front().text, "0");
  EXPECT_EQ(ticks.back().text, "4");
  const auto fine = ticksOf({"", Scaling::Linear, 0, 0.0031, {}});
  EXPECT_EQ(fine[1].text, "0.001");
}

TEST(LegendTicks, OfDegreesArePartsOfATurnOrTurns)
{
  const auto lastAndCount = [](double high) {
    ColorScale scale{"", Scaling::Linear, 0, high};
    scale.steps = TickSteps::Degrees;
    const auto ticks = ticksOf(scale);
    return std::pair(ticks.back().text, ticks.size());
  };
  EXPECT_EQ(lastAndCount(90), std::pair(std::string("90"), std::size_t{7}));
  EXPECT_EQ(lastAndCount(360), std::pair(std::string("360"), std::size_t{5}));
  EXPECT_EQ(lastAndCount(720), std::pair(std::string("720"), std::size_t{5}));
  EXPECT_EQ(lastAndCount(3600), std::pair(std::string("3600"), std::size_t{6}));
  EXPECT_EQ(lastAndCount(4), std::pair(std::string("4"), std::size_t{5}));
}

TEST(LegendTicks, OfLogarithmsArePowersOfTen)
{
  const auto ticks = ticksOf({"", Scaling::Logarithmic, 1e-15, 1e-9, {}});
  ASSERT_EQ(ticks.size(), 7);
  EXPECT_EQ(ticks.front().text, "1e-15");
  EXPECT_EQ(ticks.back().text, "1e-9");
  EXPECT_LE(ticksOf({"", Scaling::Logarithmic, 1e-15, 1e3, {}}).size(), 7);
}

}  // namespace
}  // namespace holdfast
