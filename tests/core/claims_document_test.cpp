#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/source_tree.h"

namespace holdfast {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

/// A line of docs/claims.md: words of a page, and the tests that hold them to account.
struct Claim {
  std::string page;
  std::string words;
  std::vector<std::string> tests;
};

std::string textOf(const std::filesystem::path& file)
{
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Text as it is read: one blank between words, links without their addresses, no marks of emphasis and code.
std::string plainText(const std::string& markdown)
{
  const std::string words = std::regex_replace(markdown, std::regex(R"(\[([^\]]*)\]\([^)]*\))"), "$1");
  const std::string unmarked = std::regex_replace(words, std::regex(R"([*`\\])"), "");
  return std::regex_replace(unmarked, std::regex(R"(\s+)"), " ");
}

std::vector<std::string> matchesOf(const std::string& text, const std::regex& pattern)
{
  std::vector<std::string> found;
  for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match)
    found.push_back((*match)[1]);
  return found;
}

/// The claims of a page whose sections are named after pages, and whose tables have the columns promise and tests.
std::vector<Claim> claimsOf(const std::string& text)
{
  std::vector<Claim> claims;
  std::string page;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::smatch match;
    if (std::regex_match(line, match, std::regex("## (.*)")))
      page = match[1];
    else if (std::regex_match(line, match, std::regex(R"(\| (.*) \| ([^|]*) \|)")) && match[1] != "promise")
      claims.push_back({page, match[1], matchesOf(match[2], std::regex("`([^`]+)`"))});
  }
  return claims;
}

/// Tests below tests/ by their names: those of GoogleTest as SUITE.NAME, those of CTest as they are called there.
std::set<std::string> namesOfTests()
{
  const std::regex googleTest(R"((?:^|\n)TEST(?:_F|_P)?\((\w+, *\w+)\))");
  const std::regex ctest(R"(add_test\(NAME ([\w/.]+))");
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(test::sourceFolder() + "/tests")) {
    if (entry.path().extension() == ".cpp")
      for (const std::string& name : matchesOf(textOf(entry.path()), googleTest))
        names.insert(std::regex_replace(name, std::regex(", *"), "."));
    if (entry.path().filename() == "CMakeLists.txt")
      for (const std::string& name : matchesOf(textOf(entry.path()), ctest)) names.insert(name);
  }
  return names;
}

/// What is wrong with the claims, one sentence each.
std::vector<std::string> mistakesIn(const std::vector<Claim>& claims)
{
  const std::set<std::string> tests = namesOfTests();
  std::vector<std::string> mistakes;
  for (const Claim& claim : claims) {
    const std::string page = plainText(textOf(test::sourceFolder() + "/" + claim.page));
    if (page.find(plainText(claim.words)) == std::string::npos)
      mistakes.push_back(claim.page + " does not say: " + claim.words);
    if (claim.tests.empty()) mistakes.push_back("no test is named for: " + claim.words);
    for (const std::string& name : claim.tests)
      if (!tests.contains(name)) mistakes.push_back("there is no test " + name + " for: " + claim.words);
  }
  return mistakes;
}

TEST(ClaimsDocument, NamesWordsOfItsPagesAndTestsThatExist)
{
  const std::vector<Claim> claims = claimsOf(textOf(test::sourceFolder() + "/docs/claims.md"));
  EXPECT_THAT(mistakesIn(claims), IsEmpty());
  EXPECT_GT(claims.size(), 100u) << "the page is not read as it is written";
}

TEST(ClaimsDocument, SpeaksOfEveryPageThatPromises)
{
  std::set<std::string> pages;
  for (const Claim& claim : claimsOf(textOf(test::sourceFolder() + "/docs/claims.md"))) pages.insert(claim.page);
  std::set<std::string> expected{"README.md", "data/README.md"};
  for (const auto& entry : std::filesystem::directory_iterator(test::sourceFolder() + "/docs"))
    if (entry.path().extension() == ".md") expected.insert("docs/" + entry.path().filename().string());
  expected.erase("docs/claims.md");
  expected.erase("docs/README.md");       // a list of pages
  expected.erase("docs/performance.md");  // measurements
  EXPECT_EQ(pages, expected);
}

TEST(ClaimsDocumentMustFail, ForATestThatDoesNotExist)
{
  const std::string page =
      "## README.md\n| promise | tests |\n|---|---|\n| deforms triangle meshes | `Deform.Nothing` |\n";
  EXPECT_THAT(mistakesIn(claimsOf(page)), SizeIs(1));
}

TEST(ClaimsDocumentMustFail, ForWordsThatThePageDoesNotHave)
{
  const std::string page = "## README.md\n| promise | tests |\n|---|---|\n| makes coffee | `layering/includes` |\n";
  EXPECT_THAT(mistakesIn(claimsOf(page)), SizeIs(1));
}

TEST(ClaimsDocumentMustFail, ForALineWithoutATest)
{
  const std::string page = "## README.md\n| promise | tests |\n|---|---|\n| deforms triangle meshes | none |\n";
  EXPECT_THAT(mistakesIn(claimsOf(page)), SizeIs(1));
}

}  // namespace
}  // namespace holdfast
