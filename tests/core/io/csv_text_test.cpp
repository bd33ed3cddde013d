#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <holdfast/io/text/csv_text.h>

namespace holdfast {
namespace {

TEST(CsvText, PlainFieldsStayAsTheyAre)
{
  for (const std::string text : {"", "a", "two words", "1.5e-3", "B\xC3\xB6hm", "a;b", "a'b"})
    EXPECT_EQ(csvField(text), text);
}

TEST(CsvText, AnyTextComesBackAsOneField)
{
  for (const std::string text :
       {"a,b", "\"", "say \"a\"", "two\nlines", "two\r\nlines", "\r", " a", "a\t", ",", "\"\""}) {
    const std::vector<CsvRecord> records = splitCsv("x," + csvField(text) + ",y\n", "t");
    ASSERT_EQ(records.size(), 1U) << text;
    EXPECT_EQ(records[0].fields, (std::vector<std::string>{"x", text, "y"}));
  }
}

}  // namespace
}  // namespace holdfast
