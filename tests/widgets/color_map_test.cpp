#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <limits>
#include <set>
#include <string>
#include <utility>

#include <gtest/gtest.h>
#include <vtkLookupTable.h>

#include <holdfast/widgets/color/color_map.h>
#include <holdfast/widgets/color/scalar_legend.h>
#include <holdfast/widgets/marks/constraint_glyphs.h>

#include "support/special_values.h"
#include "widgets/lab_color.h"

namespace holdfast {
namespace {

using test::distance;
using test::LabColor;
using test::toLab;

constexpr int kSteps = 500;

LabColor labAt(int step, ColorMap map = ColorMap::BlueGreenYellow)
{
  return toLab(mapColor(step / static_cast<double>(kSteps), map));
}

constexpr std::array kMaps{ColorMap::BlueGreenYellow, ColorMap::BlueGreyYellow,
                           ColorMap::BlueWhiteOrange, ColorMap::Grey,
                           ColorMap::BlueWhiteRed,    ColorMap::BlackRedYellow};

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
  for (const ColorMap map :
       {ColorMap::BlueGreenYellow, ColorMap::BlueGreyYellow, ColorMap::Grey, ColorMap::BlackRedYellow})
    for (int k = 0; k < kSteps; ++k)
      EXPECT_LT(labAt(k, map).lightness, labAt(k + 1, map).lightness) << "map " << static_cast<int>(map) << ", " << k;
}

TEST(ColorMap, WhiteIsInTheMiddleOfTheTwoSidedOnes)
{
  for (const ColorMap map : {ColorMap::BlueWhiteOrange, ColorMap::BlueWhiteRed}) {
    for (int k = 0; k < kSteps / 2; ++k) {
      EXPECT_LT(labAt(k, map).lightness, labAt(k + 1, map).lightness) << "step " << k;
      EXPECT_GT(labAt(k + kSteps / 2, map).lightness, labAt(k + 1 + kSteps / 2, map).lightness) << "step " << k;
    }
    EXPECT_LT(distance(labAt(kSteps / 2, map), {96, 0, 0}), 0.5);
  }
}

TEST(ColorMap, NoMapHasTheColorsOfSelections)
{
  for (const Color& color : {kAccentColor, kSelectedColor})
    for (const ColorMap map : kMaps)
      for (int k = 0; k <= kSteps; ++k)
        EXPECT_GT(distance(labAt(k, map), toLab(color)), 40) << "map " << static_cast<int>(map) << ", step " << k;
}

TEST(ColorMap, EqualStepsLookAboutEqual)
{
  for (const ColorMap map : kMaps) {
    double length = 0;
    for (int k = 0; k < kSteps; ++k) length += distance(labAt(k, map), labAt(k + 1, map));
    // Control points are rounded to whole units of Lab and stand 14 to 23 apart.
    for (int k = 0; k < kSteps; ++k)
      EXPECT_NEAR(distance(labAt(k, map), labAt(k + 1, map)) * kSteps / length, 1, 0.2)
          << "map " << static_cast<int>(map) << ", step " << k;
  }
}

TEST(ColorMap, SharesFarApartLookDifferentWithoutGreenReceptors)
{
  constexpr int kTenths = 10;
  const auto seen = [](int tenth, ColorMap map) {
    return toLab(test::seenBy(test::Vision::WithoutGreen, mapColor(tenth / 10.0, map)));
  };
  for (const ColorMap map : kMaps)
    for (int a = 0; a <= kTenths; ++a)
      for (int b = a + 2; b <= kTenths; ++b)
        EXPECT_GT(distance(seen(a, map), seen(b, map)), 10) << "map " << static_cast<int>(map) << ", " << a << " " << b;
}

TEST(ColorMap, ARainbowLooksTheSameAtDifferentSharesWithoutGreenReceptors)
{
  const auto seen = [](const Color& color) { return toLab(test::seenBy(test::Vision::WithoutGreen, color)); };
  EXPECT_LT(distance(seen({0.60, 0.55, 0}), seen({0.25, 0.65, 0})), 10);
}

TEST(ColorMap, BlueToYellowSetsTheEndsApartWithoutRedAndGreen)
{
  EXPECT_LT(labAt(0).b, -40);
  EXPECT_GT(labAt(kSteps).b, 60);
}

TEST(ColorMap, NoValueIsAGreyThatNoMapHas)
{
  for (const ColorMap map : kMaps) {
    EXPECT_EQ(mapColor(test::kNan, map), kNoValueColor);
    const double least = map == ColorMap::BlueGreenYellow ? 25 : 10;
    for (int k = 0; k <= kSteps; ++k)
      EXPECT_GT(distance(labAt(k, map), toLab(kNoValueColor)), least)
          << "map " << static_cast<int>(map) << ", step " << k;
  }
}

TEST(ColorMap, TablesOfVtkHaveTheSameColors)
{
  for (const ColorMap map : kMaps) {
    ColorScale scale;
    scale.map = map;
    const auto table = toLookupTable(scale);
    for (int k = 0; k <= kSteps; ++k) {
      const double share = k / static_cast<double>(kSteps);
      const Color color = mapColor(share, map);
      const unsigned char* const drawn = table->MapValue(share);
      EXPECT_NEAR(drawn[0], 255 * color.red, 1) << share;
      EXPECT_NEAR(drawn[1], 255 * color.green, 1) << share;
      EXPECT_NEAR(drawn[2], 255 * color.blue, 1) << share;
    }
  }
}

TEST(ColorScale, HasAMap)
{
  ColorScale scale{"", Scaling::Linear, 2, 6};
  scale.map = ColorMap::Grey;
  EXPECT_EQ(colorOf(scale, 5), mapColor(0.75, ColorMap::Grey));
}

TEST(ColorScale, HasBandsOfOneColorEachFromEndToEndOfItsMap)
{
  ColorScale scale{"", Scaling::Linear, 2, 6};
  scale.bands = 4;
  for (const auto& [value, share] : {std::pair(2.0, 0.0),
                                     {2.99, 0.0},
                                     {3.01, 1 / 3.0},
                                     {3.99, 1 / 3.0},
                                     {5.5, 1.0},
                                     {6.0, 1.0},
                                     {7.0, 1.0},
                                     {1.0, 0.0}})
    EXPECT_EQ(colorOf(scale, value), mapColor(share)) << value;
  EXPECT_EQ(colorOf(scale, test::kNan), kNoValueColor);
  std::set<std::array<int, 3>> drawn;
  const auto table = toLookupTable(scale);
  for (int k = 0; k <= 1000; ++k) {
    const unsigned char* const color = table->MapValue(k / 1000.0);
    drawn.insert({color[0], color[1], color[2]});
  }
  EXPECT_EQ(drawn.size(), 4U);
}

TEST(ColorScale, NoValueOfABorderIsBetweenTwoColorsOfTheTable)
{
  for (const Outside outside : {Outside::AsEnds, Outside::Marked})
    for (int bands = 2; bands <= kMostBands; ++bands)
      for (int k = 0; k <= bands; ++k) {
        ColorScale scale{"", Scaling::Linear, 0, static_cast<double>(bands)};
        scale.bands = bands;
        scale.outside = outside;
        const auto colors = static_cast<double>(toLookupTable(scale)->GetNumberOfTableValues());
        const double place = tablePlace(scale, k) * colors;
        EXPECT_GT(std::abs(place - std::round(place)), 1e-3) << k << " of " << bands;
      }
}

TEST(ColorScale, TheValueWhereTwoBandsMeetIsOfTheUpperOneInTheTableToo)
{
  for (int bands = 2; bands <= kMostBands; ++bands) {
    ColorScale scale{"", Scaling::Linear, -1, 1};
    scale.bands = bands;
    scale.outside = bands % 2 == 0 ? Outside::AsEnds : Outside::Marked;
    const auto table = toLookupTable(scale);
    for (int k = 1; k < bands; ++k) {
      const double value = -1 + 2.0 * k / bands;
      const Color color = mapColor(k / (bands - 1.0));
      const unsigned char* const drawn = table->MapValue(tablePlace(scale, value + 1e-12));
      EXPECT_NEAR(drawn[0], 255 * color.red, 1) << k << " of " << bands;
      EXPECT_NEAR(drawn[1], 255 * color.green, 1) << k << " of " << bands;
    }
  }
}

TEST(ColorScale, MarksWhatIsBelowAndBeyondItsEnds)
{
  ColorScale scale{"", Scaling::Linear, 2, 6};
  EXPECT_EQ(colorOf(scale, 1.9), colorOf(scale, 2)) << "not by itself";
  scale.outside = Outside::Marked;
  EXPECT_EQ(colorOf(scale, 1.9), kBelowColor);
  EXPECT_EQ(colorOf(scale, 6.1), kBeyondColor);
  EXPECT_EQ(colorOf(scale, 2), mapColor(0));
  EXPECT_EQ(colorOf(scale, 6), mapColor(1));
  const auto drawn = [&](double value) {
    const auto table = toLookupTable(scale);
    const unsigned char* const color = table->MapValue(tablePlace(scale, value));
    return std::array{color[0] / 255.0, color[1] / 255.0, color[2] / 255.0};
  };
  for (const auto& [value, color] :
       {std::pair(1.9, kBelowColor), {6.1, kBeyondColor}, {2.0, mapColor(0)}, {6.0, mapColor(1)}}) {
    EXPECT_NEAR(drawn(value)[0], color.red, 0.01) << value;
    EXPECT_NEAR(drawn(value)[1], color.green, 0.01) << value;
    EXPECT_NEAR(drawn(value)[2], color.blue, 0.01) << value;
  }
}

TEST(ColorScale, MarksResidualsOfZeroOnALogarithmicScale)
{
  ColorScale scale{"", Scaling::Logarithmic, 1e-6, 1e-2};
  scale.outside = Outside::Marked;
  EXPECT_LT(tablePlace(scale, 0), 0);
  EXPECT_LT(tablePlace(scale, 1e-7), 0);
  EXPECT_GT(tablePlace(scale, 1), 1);
}

TEST(ColorMap, NoMapHasTheColorsOutsideItsScale)
{
  for (const Color& color : {kBelowColor, kBeyondColor})
    for (const ColorMap map : kMaps)
      for (int k = 0; k <= kSteps; ++k) {
        EXPECT_GT(distance(labAt(k, map), toLab(color)), 30) << "map " << static_cast<int>(map) << ", step " << k;
        const auto seen = [](const Color& of) { return toLab(test::seenBy(test::Vision::WithoutGreen, of)); };
        EXPECT_GT(distance(seen(mapColor(k / double{kSteps}, map)), seen(color)), 15)
            << static_cast<int>(map) << ", " << k;
      }
}

TEST(ColorScale, OfSignedValuesHasWhiteAtZeroWhereverItsEndsAre)
{
  for (const auto& [low, high] : {std::pair(-1.0, 1.0), {-1.0, 3.0}, {-5.0, 0.5}, {0.0, 2.0}, {-2.0, 0.0}}) {
    ColorScale scale{"", Scaling::Linear, low, high};
    scale.map = ColorMap::BlueWhiteRed;
    scale.isSigned = true;
    EXPECT_LT(distance(toLab(colorOf(scale, 0)), {96, 0, 0}), 1) << low << " to " << high;
    const double reach = std::max(-low, high);
    EXPECT_LT(distance(toLab(colorOf(scale, high)), toLab(mapColor(0.5 + high / (2 * reach), scale.map))), 0.01);
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
  EXPECT_TRUE(std::isnan(shareOf(scale, test::kNan)));
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

ColorScale linearScale(double low, double high)
{
  return {"", Scaling::Linear, low, high, {}};
}

/// Few, ascending, inside but for a thousandth of their distance, and none with the text of another.
void expectTold(double low, double high)
{
  const auto ticks = ticksOf(linearScale(low, high));
  SCOPED_TRACE(testing::Message() << std::setprecision(17) << low << " to " << high);
  ASSERT_GE(ticks.size(), 2U);
  EXPECT_LE(ticks.size(), 8U);
  const double beside = 1e-3 * (ticks[1].value - ticks[0].value);
  EXPECT_GE(ticks.front().value, low - beside);
  EXPECT_LE(ticks.back().value, high + beside);
  for (std::size_t k = 1; k < ticks.size(); ++k) {
    EXPECT_GT(ticks[k].value, ticks[k - 1].value);
    EXPECT_NE(ticks[k].text, ticks[k - 1].text);
  }
}

TEST(LegendTicks, OfARangeOfOneUnitInTheLastPlaceAreItsEnds)
{
  for (const double low : {1.0, 3.0e5, -1.0, 1e300, -7e-300, 0.0, 5e-324, 360.0}) {
    const double high = std::nextafter(low, std::numeric_limits<double>::infinity());
    const auto ticks = ticksOf(linearScale(low, high));
    ASSERT_EQ(ticks.size(), 2U) << low;
    EXPECT_EQ(ticks[0].value, low);
    EXPECT_EQ(ticks[1].value, high);
    EXPECT_NE(ticks[0].text, ticks[1].text);
    ColorScale degrees = linearScale(low, high);
    degrees.steps = TickSteps::Degrees;
    EXPECT_EQ(ticksOf(degrees).size(), 2U) << low;
  }
}

TEST(LegendTicks, AreFewAndDifferHoweverNarrowTheRangeIs)
{
  for (const double low : {-1000.0, -1.0, 0.3, 1.0, 1e6})
    for (double share = 1; share > 1e-17; share /= 7) {
      const double high = low + share * std::abs(low);
      if (high > low) expectTold(low, high);
    }
  expectTold(-1e308, 1e308);
  expectTold(0, 1e-320);
}

TEST(LegendTicks, OfARangeBelowZeroMirrorThoseAboveIt)
{
  for (const auto& [low, high] :
       {std::pair(1.0, 4.0), {0.1, 0.3}, {0.7, 0.8}, {0.6, 1.2}, {1000.0, 1000.001}, {3e-7, 9e-7}, {0.0, 4.37}}) {
    const auto above = ticksOf(linearScale(low, high));
    auto below = ticksOf(linearScale(-high, -low));
    std::reverse(below.begin(), below.end());
    ASSERT_EQ(above.size(), below.size()) << low << " to " << high;
    for (std::size_t k = 0; k < above.size(); ++k) EXPECT_EQ(above[k].value, -below[k].value) << low << " to " << high;
  }
  const auto ticks = ticksOf(linearScale(-0.5, 0.5));
  EXPECT_TRUE(std::any_of(ticks.begin(), ticks.end(), [](const Tick& tick) { return tick.text == "0"; })) << "no -0";
  EXPECT_EQ(ticksOf(linearScale(-3, -1)).back().text, "-1");
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

TEST(LegendTicks, OfBandsAreWhereColorsChange)
{
  const auto ticksOfBands = [](double low, double high, int bands) {
    ColorScale scale{"", Scaling::Linear, low, high};
    scale.bands = bands;
    std::vector<std::string> texts;
    for (const Tick& tick : ticksOf(scale)) {
      const double border = (tick.value - low) / (high - low) * bands;
      EXPECT_NEAR(border, std::round(border), 1e-9) << tick.text << " of " << bands;
      EXPECT_NEAR(std::stod(tick.text), tick.value, 0.01 * (high - low) / bands) << tick.text;
      texts.push_back(tick.text);
    }
    return texts;
  };
  EXPECT_EQ(ticksOfBands(-0.1, 0.1, 6),
            (std::vector<std::string>{"-0.1", "-0.0667", "-0.0333", "0", "0.0333", "0.0667", "0.1"}));
  EXPECT_EQ(ticksOfBands(0, 4.37, 2), (std::vector<std::string>{"0", "2.19", "4.37"}));
  EXPECT_EQ(ticksOfBands(1000, 1001, 4), (std::vector<std::string>{"1000", "1000.25", "1000.5", "1000.75", "1001"}));
  EXPECT_EQ(ticksOfBands(-3, 3, 20).size(), 11U) << "every second one, the ends and zero among them";
  EXPECT_LE(ticksOfBands(0, 1, kMostBands).size(), 11U);
}

TEST(LegendTicks, OfLogarithmicBandsAreWhereColorsChange)
{
  ColorScale scale{"", Scaling::Logarithmic, 1e-6, 1};
  scale.bands = 3;
  const auto ticks = ticksOf(scale);
  ASSERT_EQ(ticks.size(), 4);
  EXPECT_EQ(ticks[1].text, "0.0001");
  EXPECT_NEAR(ticks[2].value, 1e-2, 1e-12);
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
