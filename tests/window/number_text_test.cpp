#include <QString>
#include <cmath>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include <holdfast/window/text/number_text.h>

namespace holdfast {
namespace {

/// Returns the text with "_" in place of narrow spaces.
std::string seen(QString text)
{
  return text.replace(QChar(0x202f), '_').toStdString();
}

TEST(NumberWords, CountsAreInGroupsOfThree)
{
  EXPECT_EQ(seen(countText(0)), "0");
  EXPECT_EQ(seen(countText(999)), "999");
  EXPECT_EQ(seen(countText(1000)), "1_000");
  EXPECT_EQ(seen(countText(173402)), "173_402");
  EXPECT_EQ(seen(countText(12345678)), "12_345_678");
}

TEST(NumberWords, ExactTextsReadBackBitForBit)
{
  for (const double value : {0.1, 1.0 / 3, -2e-17, 1e300, 5e-324, std::nextafter(1.0, 2.0), 12.3456789012345678})
    EXPECT_EQ(typedNumber(' ' + exactText(value) + ' '), value) << exactText(value).toStdString();
  EXPECT_TRUE(std::signbit(typedNumber(exactText(-0.0)).value()));
}

TEST(NumberWords, WhatIsNoFiniteNumberIsNothing)
{
  for (const char* const typed : {"", "1,5", "1 000", "nan", "inf", "1e999", "2 mm"})
    EXPECT_EQ(typedNumber(typed), std::nullopt) << typed;
}

TEST(NumberWords, CoordinatesAreExactAsLongAsTheyAreShort)
{
  EXPECT_EQ(coordinateText(0.1).toStdString(), "0.1");
  EXPECT_EQ(coordinateText(-41.5).toStdString(), "-41.5");
  EXPECT_EQ(coordinateText(1.0 / 3).toStdString(), "0.33333");
}

TEST(NumberWords, NumbersHaveTheDigitsThatFitAndTwoAtLeast)
{
  const auto within = [](double value, int most) {
    return fittingText(value, coordinateText(value), [most](const QString& text) { return text.size() <= most; })
        .toStdString();
  };
  EXPECT_EQ(within(-0.0995432, 9), "-0.099543");
  EXPECT_EQ(within(-0.0995432, 8), "-0.09954");
  EXPECT_EQ(within(-0.0995432, 7), "-0.0995");
  EXPECT_EQ(within(-0.0995432, 6), "-0.1");
  EXPECT_EQ(within(-123456.7, 11), "-1.2346e+05");
  EXPECT_EQ(within(-123456.7, 8), "-123457");
  EXPECT_EQ(within(-1.2345e-5, 8), "-1.2e-05");
  EXPECT_EQ(within(-1.2345e-5, 7), "…") << "one digit would be another number";
}

TEST(NumberWords, RoundingIsTakenForZeroBesideLargerNumbers)
{
  EXPECT_FALSE(std::signbit(withoutNoise(-0.0, 1)));
  EXPECT_EQ(withoutNoise(3.469e-17, 100), 0);
  EXPECT_EQ(withoutNoise(1e-9, 100), 1e-9);
  EXPECT_EQ(roundedText(Vector3(3.469e-17, -0.0, 2)).toStdString(), "(0, 0, 2)");
  EXPECT_EQ(roundedText(-0.0).toStdString(), "0");
  EXPECT_EQ(shortText(1.234e-16).toStdString(), "1.2e-16");
}

TEST(NumberWords, LengthsHaveTheDecimalsOfTheDocument)
{
  const LengthStyle thousandths{"mm", 3};
  EXPECT_EQ(lengthText(12.5, thousandths).toStdString(), "12.500 mm");
  EXPECT_EQ(numberText(-0.0004, thousandths).toStdString(), "0.000") << "nothing is minus zero";
  EXPECT_EQ(coordinateText(1.0 / 3, thousandths).toStdString(), "0.333");
  EXPECT_EQ(placeText(Vector3(1, -2.00049, 30), thousandths).toStdString(), "(1.000, -2.000, 30.000)");
  EXPECT_EQ(lengthText(12.5, {"mm", 0}).toStdString(), "12 mm");
  EXPECT_EQ(numberText(3e12, thousandths).toStdString(), "3e+12") << "decimals of so large a number say nothing";
  EXPECT_EQ(lengthText(12.3456, {"mm"}).toStdString(), "12.35 mm") << "without decimals four digits";
}

TEST(NumberWords, ALengthThatDecimalsWouldHideIsNotZero)
{
  EXPECT_EQ(lengthText(2e-7, {"mm", 3}).toStdString(), "<0.001 mm");
  EXPECT_EQ(lengthText(2e-7, {"", 0}).toStdString(), "<1");
  EXPECT_EQ(lengthText(0, {"mm", 3}).toStdString(), "0.000 mm");
}

TEST(NumberWords, WhatIsMetHasTheDigitsOfItsLimit)
{
  EXPECT_EQ(metText(1.5612e-10, "mm").toStdString(), "met ≤ 1.6e-10 mm");
  EXPECT_EQ(metText(1e-12, "").toStdString(), "met ≤ 1e-12");
  const auto within = [](int most) {
    return fittingText(3.6e-15, metText(1e-12, ""), [most](const QString& text) { return text.size() <= most; })
        .toStdString();
  };
  EXPECT_EQ(within(11), "met ≤ 1e-12");
  EXPECT_EQ(within(10), "met") << "and never the digits of rounding";
}

TEST(NumberWords, OneIsSingular)
{
  EXPECT_EQ(countText(1, "1 vertex", "%1 vertices").toStdString(), "1 vertex");
  EXPECT_EQ(countText(0, "1 vertex", "%1 vertices").toStdString(), "0 vertices");
  EXPECT_EQ(seen(countText(1200, "1 vertex", "%1 vertices")), "1_200 vertices");
}

}  // namespace
}  // namespace holdfast
