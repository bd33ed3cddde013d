#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <holdfast/io/text/loose_number.h>
#include <holdfast/numbers/same_bits.h>

namespace holdfast {
namespace {

TEST(LooseNumber, AgreesWithStrictNumbers)
{
  for (const char* token : {"0", "-0", "1.5", "+2", "1e308", "4.9e-324", ".5", "5."}) {
    EXPECT_EQ(parseLooseNumber(token).fault, NumberFault::None) << token;
    EXPECT_TRUE(hasSameBits(parseLooseNumber(token).value, parseNumber<double>(token).value)) << token;
  }
}

TEST(LooseNumber, WhatIsTooSmallIsZeroWithItsSign)
{
  for (const char* token : {"1e-400", "0.5e-999", "1234567e-99999999999999999999", "0.001e-330", "+7E-046000"}) {
    EXPECT_TRUE(hasSameBits(parseLooseNumber(token).value, 0.0)) << token;
    EXPECT_TRUE(hasSameBits(parseLooseNumber(std::string("-") + (token + (token[0] == '+' ? 1 : 0))).value, -0.0));
  }
  EXPECT_EQ(parseLooseNumber("0." + std::string(400, '0') + "1").fault, NumberFault::None);
}

TEST(LooseNumber, WhatIsTooLargeStaysOutOfRange)
{
  for (const char* token : {"1e309", "-1e999", "0.01e400", "1e99999999999999999999", "1d400"})
    EXPECT_EQ(parseLooseNumber(token).fault, NumberFault::OutOfRange) << token;
  EXPECT_EQ(parseLooseNumber("1" + std::string(400, '0')).fault, NumberFault::OutOfRange);
}

TEST(LooseNumber, NanAndInfinityMayBeSpelledAsOnWindows)
{
  for (const char* token : {"1.#QNAN", "-1.#IND", "1.#IND00", "+1.#SNAN", "1.#QNAN0", "nan", "-nan", "nan(ind)"})
    EXPECT_TRUE(std::isnan(parseLooseNumber(token).value)) << token;
  EXPECT_EQ(parseLooseNumber("1.#INF").value, std::numeric_limits<double>::infinity());
  EXPECT_EQ(parseLooseNumber("-1.#INF000").value, -std::numeric_limits<double>::infinity());
}

TEST(LooseNumber, ExponentsMayBeThoseOfFortran)
{
  EXPECT_EQ(parseLooseNumber("1.5D+03").value, 1500);
  EXPECT_EQ(parseLooseNumber("-2d-1").value, -0.2);
}

TEST(LooseNumber, AnythingElseIsNoNumber)
{
  for (const char* token : {"", "#", "1.#", "2.#INF", "1.#INFTY", "-#", "d", "1dd2", "1d2d3", "1,5", "0x1", "one"})
    EXPECT_EQ(parseLooseNumber(token).fault, NumberFault::NotANumber) << token;
}

}  // namespace
}  // namespace holdfast
