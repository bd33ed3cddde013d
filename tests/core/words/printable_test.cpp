#include <gtest/gtest.h>

#include <holdfast/words/error.h>
#include <holdfast/words/printable.h>

namespace holdfast {
namespace {

TEST(Printable, KeepsWhatIsForPrinting)
{
  for (const std::string text : {"", "P1", "Bohrung Ø 12 “links”", "穴 1 \xF0\x9F\x94\xA9", "back\\slash", "tilde ~"})
    EXPECT_EQ(printable(text), text);
}

TEST(Printable, WritesTheBytesOfAllElse)
{
  EXPECT_EQ(printable("a\nb\r\tc"), R"(a\x0ab\x0d\x09c)");
  EXPECT_EQ(printable("\x1B[2J\x7F"), R"(\x1b[2J\x7f)");
  EXPECT_EQ(printable(std::string_view("\0", 1)), R"(\x00)");
  EXPECT_EQ(printable("\xC2\x9B"
                      "2J"),
            R"(\xc2\x9b2J)")
      << "a control character beyond ASCII";
  EXPECT_EQ(printable("a\xE2\x80\xA8"
                      "b\xE2\x80\xA9"),
            R"(a\xe2\x80\xa8b\xe2\x80\xa9)")
      << "separators of lines";
  EXPECT_EQ(printable("\xE2\x80\xAE"
                      "jbo.tuo"),
            R"(\xe2\x80\xaejbo.tuo)")
      << "from right to left";
  EXPECT_EQ(printable("\xE2\x81\xA6\xD8\x9C"), R"(\xe2\x81\xa6\xd8\x9c)");
}

TEST(Printable, WritesBytesThatAreNoCharacters)
{
  EXPECT_EQ(printable("M\xFCnster"), R"(M\xfcnster)");
  EXPECT_EQ(printable("\xC0\xAF\xED\xA0\x80\xF5\x80"), R"(\xc0\xaf\xed\xa0\x80\xf5\x80)");
  EXPECT_EQ(printable("cut \xE2\x82"), R"(cut \xe2\x82)");
}

TEST(Printable, IsTheSameTwice)
{
  const std::string once = printable(
      "a\n\x1B\xFF"
      "ö");
  EXPECT_EQ(printable(once), once);
}

TEST(Printable, CutsBetweenCharacters)
{
  EXPECT_EQ(printable("abcdef", 6), "abcdef");
  EXPECT_EQ(printable("abcdefg", 6), "abcdef...");
  EXPECT_EQ(printable("abcdeö", 6), "abcde...");
  EXPECT_EQ(printable("abcd\xF0\x9F\x94\xA9", 7), "abcd...");
  EXPECT_EQ(inQuotes(std::string(100000, 'x')), '"' + std::string(60, 'x') + "...\"");
}

TEST(Errors, SayAllOnOnePrintableLine)
{
  const InputError input({"a\nb.obj", 3, "\x1B[2J"}, "is\nwrong");
  EXPECT_STREQ(input.what(), R"(a\x0ab.obj:3: \x1b[2J: is\x0awrong)");
  EXPECT_EQ(input.location().file, "a\nb.obj");
  const OutputError output("a\nb.obj", "cannot be written");
  EXPECT_STREQ(output.what(), R"(a\x0ab.obj: cannot be written)");
  EXPECT_EQ(output.path(), "a\nb.obj");
  EXPECT_EQ(output.reason(), "cannot be written");
  EXPECT_LT(std::string(InputError({}, std::string(1000000, 'x')).what()).size(), 10000U);
}

}  // namespace
}  // namespace holdfast
