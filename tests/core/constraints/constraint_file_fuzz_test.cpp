#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/words/error.h>

#include "support/constraint_lists.h"

namespace holdfast {
namespace {

constexpr std::string_view kPointList =
    "name,x,y,z,target_x,target_y,target_z\r\n\"bolt \"\"A\"\", "
    "left\",1,2,3,4,5,6\r\n,1e-3,-2.5,3,4,5,6\n\nB,0,0,0,1,1,1";

/// Pieces of text that parsers trip over.
constexpr std::array<std::string_view, 24> kPieces{
    "{",    "}",    "[",       "]",     ",",       ":",         "\"",
    "\\",   "null", "-1",      "1e999", "\xFF",    "\xE2",      "\r\n",
    "true", "\t",   "1e-99",   "0.1",   "\\u0000", "{\"not\":", "99999999999999999999",
    ";",    "nan",  "\"name\""};

std::size_t place(test::Random& random, const std::string& text)
{
  return static_cast<std::size_t>(random.integer(0, static_cast<long>(text.size())));
}

std::string mutated(test::Random& random, std::string text)
{
  for (long i = random.integer(1, 4); i > 0; --i) {
    const std::size_t at = place(random, text);
    const std::size_t length = std::min<std::size_t>(random.integer(1, 20), text.size() - at);
    switch (random.integer(0, 4)) {
      case 0:
        text.resize(at);
        break;
      case 1:
        text.erase(at, length);
        break;
      case 2:
        text.insert(at, kPieces[random.integer(0, kPieces.size() - 1)]);
        break;
      case 3:
        text.insert(place(random, text), text.substr(at, length));
        break;
      default:
        if (at < text.size()) text[at] = static_cast<char>(random.integer(0, 255));
    }
  }
  return text;
}

ConstraintList parsePoints(std::string_view text, const std::string& name)
{
  return parsePointListCsv(text, name);
}

enum class Outcome { Read, Refused };

/// Anything but a list or an `InputError` with a reason ends the test.
template <class Parse>
Outcome outcomeOf(Parse parse, const std::string& text)
{
  try {
    static_cast<void>(parse(text, "f"));
    return Outcome::Read;
  } catch (const InputError& error) {
    EXPECT_EQ(error.location().file, "f");
    EXPECT_FALSE(error.reason().empty());
    EXPECT_TRUE(error.location().line > 0 || !error.location().element.empty()) << error.what();
    EXPECT_LT(error.reason().size(), 2000U);
    return Outcome::Refused;
  }
}

TEST(ConstraintFileFuzz, MutatedJsonIsReadOrRefused)
{
  test::Random random(301);
  std::array<int, 2> counts{};
  for (int i = 0; i < 300; ++i) {
    const std::string text = constraintsToJson(test::randomConstraintList(random, 4));
    for (int j = 0; j < 20; ++j) ++counts[static_cast<int>(outcomeOf(parseConstraintsJson, mutated(random, text)))];
  }
  EXPECT_GT(counts[0], 50);
  EXPECT_GT(counts[1], 1000);
}

TEST(ConstraintFileFuzz, WhatIsReadFromMutatedJsonCanBeWrittenAndReadBack)
{
  test::Random random(302);
  for (int i = 0; i < 2000; ++i) {
    const std::string text = mutated(random, constraintsToJson(test::randomConstraintList(random, 2)));
    ConstraintList list;
    try {
      list = parseConstraintsJson(text, "f");
    } catch (const InputError&) {
      continue;
    }
    EXPECT_TRUE(test::areSame(list, parseConstraintsJson(constraintsToJson(list), "f"))) << text;
  }
}

TEST(ConstraintFileFuzz, EveryTruncationOfJsonIsRefused)
{
  test::Random random(303);
  const std::string text = constraintsToJson(test::randomConstraintList(random, 6));
  const std::size_t end = text.rfind('}');
  for (std::size_t length = 0; length <= end; ++length)
    ASSERT_EQ(outcomeOf(parseConstraintsJson, text.substr(0, length)), Outcome::Refused) << length;
}

TEST(ConstraintFileFuzz, MutatedCsvIsReadOrRefused)
{
  test::Random random(304);
  std::array<int, 2> counts{};
  for (int i = 0; i < 10000; ++i)
    ++counts[static_cast<int>(outcomeOf(parsePoints, mutated(random, std::string(kPointList))))];
  EXPECT_GT(counts[0], 100);
  EXPECT_GT(counts[1], 1000);
}

TEST(ConstraintFileFuzz, EveryTruncationOfCsvIsReadOrRefused)
{
  for (std::size_t length = 0; length <= kPointList.size(); ++length)
    static_cast<void>(outcomeOf(parsePoints, std::string(kPointList.substr(0, length))));
}

}  // namespace
}  // namespace holdfast
