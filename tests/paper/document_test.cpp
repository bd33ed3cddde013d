// docs/paper.md as the program writes it.

#include "bench/paper/document.h"

#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bench/paper/experiments.h"
#include "support/source_tree.h"

namespace holdfast::paper {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Le;
using testing::Not;

std::string pageOfProject()
{
  return readFile(test::sourceFolder() + "/docs/paper.md");
}

Section sectionCalled(const std::string& title, const std::string& method)
{
  Section section;
  section.title = title;
  section.method = method;
  return section;
}

TEST(PaperDocument, HasTheSectionsThatTheProgramWrites)
{
  std::vector<std::string> titles;
  for (const Experiment& experiment : allExperiments()) titles.emplace_back(experiment.title);
  EXPECT_EQ(titlesOf(pageOfProject()), titles);
}

TEST(PaperDocument, HasThePicturesThatAreCommitted)
{
  std::set<std::string> shown;
  const std::string page = pageOfProject();
  const std::regex pattern(R"(\]\(images/paper/([^)]*)\))");
  for (std::sregex_iterator match(page.begin(), page.end(), pattern), end; match != end; ++match)
    shown.insert((*match)[1]);
  std::set<std::string> committed;
  for (const auto& entry : std::filesystem::directory_iterator(test::sourceFolder() + "/docs/images/paper"))
    committed.insert(entry.path().filename());
  EXPECT_EQ(shown, committed);
}

TEST(PaperDocument, HasTheIntroductionOfTheProgram)
{
  const std::string introduction = document({}, {}, "");
  EXPECT_EQ(pageOfProject().substr(0, introduction.size()), introduction);
}

TEST(PaperDocument, KeepsSectionsThatWereNotMadeAgain)
{
  const std::string before = document({"A", "B"}, {sectionCalled("A", "old"), sectionCalled("B", "old too")}, "");
  const std::string after = document({"A", "B", "C"}, {sectionCalled("C", "new"), sectionCalled("A", "newer")}, before);
  EXPECT_THAT(titlesOf(after), ElementsAre("A", "B", "C"));
  EXPECT_THAT(after, HasSubstr("newer"));
  EXPECT_THAT(after, HasSubstr("old too"));
  EXPECT_THAT(after, Not(HasSubstr("old\n")));
}

TEST(PaperDocument, LosesSectionsThatNoExperimentWrites)
{
  const std::string before = document({"A", "B"}, {sectionCalled("A", "old"), sectionCalled("B", "old")}, "");
  EXPECT_THAT(titlesOf(document({"B"}, {}, before)), ElementsAre("B"));
}

TEST(PaperDocument, IsTheSameWhenNothingWasMadeAgain)
{
  const std::string before = document({"A", "B"}, {sectionCalled("A", "old"), sectionCalled("B", "old")}, "");
  EXPECT_EQ(document({"A", "B"}, {}, before), before);
}

TEST(PaperDocument, WrapsProseWithoutLosingWords)
{
  std::string text;
  for (int k = 0; k < 100; ++k) text += "word" + std::to_string(k) + ' ';
  std::istringstream lines(wrapped(text));
  std::string joined;
  for (std::string line; std::getline(lines, line); joined += line + ' ') EXPECT_THAT(line.size(), Le(100));
  EXPECT_EQ(joined, text);
}

TEST(PaperDocument, ShowsCommittedPicturesAndNamesOthers)
{
  Section section = sectionCalled("A", "method");
  section.pictures = {{"own.png", "ours", true}, {"out/paper/fetched.png", "theirs", false}};
  const std::string text = toMarkdown(section);
  EXPECT_THAT(text, HasSubstr("![ours](images/paper/own.png)"));
  EXPECT_THAT(text, HasSubstr("`out/paper/fetched.png`: theirs"));
}

}  // namespace
}  // namespace holdfast::paper
