#include <bit>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <holdfast/io/text/number_text.h>
#include <holdfast/io/text/text_cursor.h>
#include <holdfast/numbers/same_bits.h>
#include <holdfast/words/error.h>

#include "support/random.h"

namespace holdfast {
namespace {

constexpr TextDialect kDialect{'#', '\\'};

TEST(TextCursor, TokensKnowTheirLine)
{
  TextCursor cursor("a b\r\n\n# no token\n  c \\\n d#e\nf", "file", kDialect);
  std::string seen;
  while (cursor.findToken()) {
    const std::string_view token = cursor.token();
    seen += std::string(token) + std::to_string(cursor.line()) + " ";
  }
  EXPECT_EQ(seen, "a1 b1 c4 d5 f6 ");
}

/// The tokens of a text, each with its line.
std::string tokensAndLines(std::string_view text)
{
  TextCursor cursor(text, "file", kDialect);
  std::string seen;
  while (cursor.findToken()) {
    const std::string_view token = cursor.token();
    seen += std::string(token) + std::to_string(cursor.line()) + " ";
  }
  return seen;
}

TEST(TextCursor, LinesEndInAnyWay)
{
  for (const char* text : {"a\n# x\nb \\\nc\n\nd", "a\r# x\rb \\\rc\r\rd", "a\r\n# x\r\nb \\\r\nc\r\n\r\nd",
                           "a\r\r\n# x\r\r\nb \\\r\r\nc\r\r\n\r\r\nd", "a\n# x\rb \\ \t\r\nc\n\rd"})
    EXPECT_EQ(tokensAndLines(text), "a1 b3 c4 d6 ") << testing::PrintToString(text);
}

TEST(TextCursor, SkippedLinesEndInAnyWay)
{
  for (const char* text : {"a x\nb", "a x\rb", "a x\r\nb", "a x # \\\nb", "a # x \\\rb"}) {
    TextCursor cursor(text, "file", kDialect);
    EXPECT_EQ(cursor.token(), "a");
    cursor.skipLine();
    EXPECT_EQ(cursor.token(), "b") << testing::PrintToString(text);
    EXPECT_EQ(cursor.line(), 2);
  }
}

TEST(TextCursor, ABackslashBehindANameMayEndIt)
{
  for (const auto& [glued, next] : {std::pair(GluedBackslash::EndsAName, "b"), {GluedBackslash::Continues, "c"}}) {
    TextCursor cursor("name a\\\nb\nc", "file", kDialect);
    cursor.skipLine(glued);
    EXPECT_EQ(cursor.token(), next);
  }
  TextCursor cursor("name a \\\nb\nc", "file", kDialect);
  cursor.skipLine(GluedBackslash::EndsAName);
  EXPECT_EQ(cursor.token(), "c");
}

TEST(TextCursor, MarksAtTheBeginningOfLinesArePassedOver)
{
  EXPECT_EQ(tokensAndLines("\xEF\xBB\xBF"
                           "a\n\xEF\xBB\xBF"
                           "b\n \xEF\xBB\xBF c"),
            "a1 b2 c3 ");
}

TEST(TextCursor, AHashInANumberOfWindowsBeginsNoComment)
{
  EXPECT_EQ(tokensAndLines("-1.#IND 1.#INF#comment\n1.#a 1#INF"), "-1.#IND1 1.#INF1 1.2 ");
}

TEST(TextCursor, PaddingBehindATextIsNoPartOfIt)
{
  EXPECT_EQ(withoutPadding(std::string_view("a\0b\x1A\0\0", 6)), std::string_view("a\0b", 3));
  EXPECT_EQ(withoutPadding(std::string_view("\0\0", 2)), "");
}

TEST(TextCursor, ALineEndsItsTokens)
{
  TextCursor cursor("a\nb", "file");
  EXPECT_EQ(cursor.token(), "a");
  EXPECT_EQ(cursor.token(), "");
  cursor.skipLine();
  EXPECT_EQ(cursor.token(), "b");
}

TEST(TextCursor, BehindTheLastLineEndErrorsNameTheLastLine)
{
  TextCursor cursor("a\nb\n", "file");
  while (cursor.findToken()) static_cast<void>(cursor.token());
  EXPECT_EQ(cursor.line(), 2);
}

TEST(TextCursor, QuotesWhatCannotBePrinted)
{
  EXPECT_EQ(quotedToken(std::string_view("a\0\x80", 3)), "'a\\x00\\x80'");
  EXPECT_EQ(quotedToken(std::string(100, 'x')), "'" + std::string(40, 'x') + "...'");
}

TEST(NumberText, EveryDoubleReadsBackTheSame)
{
  test::Random random(99);
  for (int i = 0; i < 20000; ++i) {
    std::uint64_t bits = 0;
    for (int part = 0; part < 4; ++part) bits = bits << 16U | static_cast<std::uint64_t>(random.integer(0, 65535));
    const auto value = std::bit_cast<double>(bits);
    if (std::isnan(value)) continue;
    ASSERT_TRUE(hasSameBits(parseNumber<double>(NumberText(value).view()).value, value)) << value;
  }
}

TEST(NumberText, ExtremesReadBackTheSame)
{
  using Limits = std::numeric_limits<double>;
  for (const double value : {0.0, -0.0, Limits::max(), Limits::lowest(), Limits::min(), Limits::denorm_min(),
                             -Limits::denorm_min(), Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN()})
    EXPECT_TRUE(hasSameBits(parseNumber<double>(NumberText(value).view()).value, value)) << value;
}

TEST(NumberText, WhatIsNoNumberIsSaidToBeNone)
{
  for (const char* token : {"", "+", "-", ".", "e5", "1e", "1,5", "0x1", "--1", "+-1", "++1", "1 ", "infinit"})
    EXPECT_EQ(parseNumber<double>(token).fault, NumberFault::NotANumber) << token;
  for (const char* token : {"", "+", "1.0", "1e3", "+-1", "0x1", "one"})
    EXPECT_EQ(parseNumber<Index>(token).fault, NumberFault::NotANumber) << token;
  for (const char* token : {"1e309", "-1e309", "1e-400"})
    EXPECT_EQ(parseNumber<double>(token).fault, NumberFault::OutOfRange) << token;
  EXPECT_EQ(parseNumber<Index>("9223372036854775808").fault, NumberFault::OutOfRange);
}

}  // namespace
}  // namespace holdfast
