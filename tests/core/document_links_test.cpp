// Links of the project's pages lead somewhere, and the pages name the version of the program.

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/version.h>

#include "support/source_tree.h"
#include "support/temporary_folder.h"

namespace holdfast {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;

/// Returns the lines of a page without its fenced blocks, whose brackets are those of programs.
std::vector<std::string> proseOf(const std::string& page)
{
  std::vector<std::string> lines;
  bool isFenced = false;
  std::istringstream text(page);
  for (std::string line; std::getline(text, line);) {
    const bool isFence = line.starts_with("```");
    if (isFence) isFenced = !isFenced;
    if (!isFence && !isFenced) lines.push_back(line);
  }
  return lines;
}

/// Returns the name by which links call a heading: small letters, blanks as "-", no other punctuation.
std::string anchorOfHeading(const std::string& heading)
{
  std::string anchor;
  for (const char c : std::regex_replace(heading, std::regex(R"(\[([^\]]*)\]\([^)]*\))"), "$1")) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == ' ')
      anchor += '-';
    else if (c == '-' || c == '_' || byte >= 128 || std::isalnum(byte) != 0)
      anchor += static_cast<char>(std::tolower(byte));
  }
  return anchor;
}

std::set<std::string> anchorsOf(const std::string& page)
{
  std::set<std::string> anchors;
  std::smatch match;
  for (const std::string& line : proseOf(page))
    if (std::regex_match(line, match, std::regex("#+ +(.*)"))) anchors.insert(anchorOfHeading(match[1]));
  return anchors;
}

/// Returns the targets of links to files and headings. It leaves out links to other sites.
std::vector<std::string> relativeLinksOf(const std::string& page)
{
  const std::regex link(R"(\]\(([^)\s]+)\))");
  std::vector<std::string> targets;
  for (const std::string& line : proseOf(page))
    for (std::sregex_iterator match(line.begin(), line.end(), link), end; match != end; ++match)
      if (const std::string target = (*match)[1]; target.find("://") == std::string::npos) targets.push_back(target);
  return targets;
}

/// Returns the links of a page that lead nowhere, each as "file: link".
std::vector<std::string> brokenLinksOf(const fs::path& file)
{
  std::vector<std::string> broken;
  for (const std::string& target : relativeLinksOf(test::bytesOf(file))) {
    const std::size_t hash = std::min(target.find('#'), target.size());
    const fs::path to = hash == 0 ? file : file.parent_path() / target.substr(0, hash);
    const bool isThere =
        fs::exists(to) && (hash == target.size() || anchorsOf(test::bytesOf(to)).contains(target.substr(hash + 1)));
    if (!isThere) broken.push_back(file.filename().string() + ": " + target);
  }
  return broken;
}

std::vector<fs::path> pagesOfProject()
{
  const fs::path root = test::sourceFolder();
  std::vector<fs::path> pages{root / "README.md", root / "CHANGELOG.md", root / "CONTRIBUTING.md"};
  for (const char* folder : {"docs", "data"})
    for (const auto& entry : fs::recursive_directory_iterator(root / folder))
      if (entry.path().extension() == ".md") pages.push_back(entry.path());
  return pages;
}

TEST(DocumentLinks, LeadToFilesAndHeadings)
{
  std::size_t count = 0;
  for (const fs::path& page : pagesOfProject()) {
    EXPECT_THAT(brokenLinksOf(page), IsEmpty());
    count += relativeLinksOf(test::bytesOf(page)).size();
  }
  EXPECT_GT(count, 200U) << "the pages are not read as they are written";
}

TEST(DocumentLinksMustFail, ForAFileOrAHeadingThatIsNotThere)
{
  const test::TemporaryFolder folder;
  static_cast<void>(folder.file("other.md", "# The `one` page, and [more](https://a.b)\n"));
  const fs::path page = folder.file("page.md",
                                    "## Here\n[a](other.md) [b](other.md#the-one-page-and-more) [c](#here)\n"
                                    "[d](https://no.where/x.md) [e](missing.md), [f](other.md#two) [g](#there)\n"
                                    "```cpp\n[](int)\n## not-a-heading\n```\n[h](#not-a-heading)\n");
  EXPECT_THAT(brokenLinksOf(page), ElementsAre("page.md: missing.md", "page.md: other.md#two", "page.md: #there",
                                               "page.md: #not-a-heading"));
}

/// Returns what the group of a pattern holds in a file of the project, or nothing where no words match.
std::string wordsOf(const std::string& file, const std::string& pattern)
{
  const std::string text = test::bytesOf(test::sourceFolder() + "/" + file);
  std::smatch match;
  return std::regex_search(text, match, std::regex(pattern)) ? match[1].str() : std::string();
}

TEST(DocumentVersions, AreThatOfTheProgram)
{
  EXPECT_EQ(wordsOf("CITATION.cff", R"(\nversion: (\S+))"), HOLDFAST_VERSION);
  EXPECT_EQ(wordsOf("CHANGELOG.md", R"(\n## (\S+), )"), HOLDFAST_VERSION);
  EXPECT_EQ(wordsOf("CHANGELOG.md", R"(\n## \S+, (\S+))"), wordsOf("CITATION.cff", R"(\ndate-released: (\S+))"));
}

}  // namespace
}  // namespace holdfast
