#include "support/paper_equations.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

#include "support/source_tree.h"

namespace holdfast {
namespace {

namespace fs = std::filesystem;

std::string contentOf(const fs::path& path)
{
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<test::PaperEquations> equationTable()
{
  return test::paperEquations(contentOf(fs::path(test::sourceFolder()) / "docs/math.md"));
}

/// The sources, tests and documents, each with its sentences.
template <class Check>
void forEachSentence(Check&& check)
{
  const fs::path root = test::sourceFolder();
  for (const char* folder : {"core", "widgets", "app", "bench", "tests", "data", "docs"})
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / folder)) {
      const std::string ending = entry.path().extension().string();
      if (ending == ".md")
        for (const std::string& sentence : test::sentencesOfDocument(contentOf(entry))) check(entry.path(), sentence);
      if (ending == ".h" || ending == ".cpp")
        for (const std::string& sentence : test::sentencesOfComments(contentOf(entry))) check(entry.path(), sentence);
    }
}

TEST(PaperEquations, AreNamedByTheirNumbersEverywhere)
{
  const std::vector<test::PaperEquations> table = equationTable();
  std::size_t count = 0;
  forEachSentence([&](const fs::path& path, const std::string& sentence) {
    count += test::namedEquationCount(sentence);
    for (const std::string& mistake : test::misnamedEquations(sentence, table))
      ADD_FAILURE() << path << ": " << mistake;
  });
  EXPECT_GT(count, 60U) << "the search finds what is there";
}

TEST(PaperEquations, OfTheTableAreThoseOfThePaper)
{
  struct Known {
    int number;
    const char* meaning;
  };
  const std::vector<test::PaperEquations> table = equationTable();
  for (const auto& [number, meaning] :
       {Known{4, "vertex"}, Known{5, "edge"}, Known{6, "face"}, Known{9, "1 / n_i"},
        Known{10, "(cot a_ij + cot b_ij) / (2 Area(i))"}, Known{12, "B p = d"}, Known{14, "B^T = Q R"},
        Known{18, "R1^T y = d"}, Known{25, "L q = 0"}, Known{26, "q = 0"}, Known{27, "q = r"}, Known{29, "equal"}}) {
    const auto row = std::find_if(table.begin(), table.end(), [number = number](const test::PaperEquations& equations) {
      return equations.first == number && equations.last == number;
    });
    ASSERT_NE(row, table.end()) << number;
    EXPECT_NE(row->meaning.find(meaning), std::string::npos) << number;
  }
  for (int number = 1; number <= 29; ++number)
    EXPECT_TRUE(std::any_of(table.begin(), table.end(), [&](const test::PaperEquations& row) {
      return row.first <= number && number <= row.last;
    })) << number;
}

TEST(PaperEquations, OfTheTableAreInTheFilesThatItNames)
{
  for (const test::PaperEquations& row : equationTable()) {
    EXPECT_FALSE(row.places.empty()) << row.meaning;
    for (const std::string& place : row.places)
      EXPECT_TRUE(fs::exists(fs::path(test::sourceFolder()) / "core/holdfast" / place)) << place;
  }
}

class MisnamedEquation : public testing::TestWithParam<const char*> {};

TEST_P(MisnamedEquation, IsFound)
{
  EXPECT_FALSE(test::misnamedEquations(GetParam(), equationTable()).empty());
}

INSTANTIATE_TEST_SUITE_P(PaperEquations, MisnamedEquation,
                         testing::Values("R1^T y = d, (16)", "R1^T y = d, (14)",
                                         "(12), (13) B^T = Q R, u = Q1 y + Q2 z",
                                         "Hard constraints by elimination, equations (12) to (17).",
                                         "the normal equations of (20), (21)", "Soft constraints, (7)",
                                         "Fixed vertices do not turn, q = 0 (27)", "a point of an edge, equation (6)",
                                         "the vectors of a rigid region (29)", "as in equation 30", "see (31)"));

TEST(PaperEquations, NamedRightlyAreNotMistaken)
{
  for (const char* sentence :
       {"R1^T y = d, (18)", "Hard constraints, equations (11) to (21).", "(7) and (8): soft constraints",
        "fixed vertices and handles, (26) and (27)", "f(30) and O(1) are no equations", "a list (of 31) of (a, 17)"})
    EXPECT_EQ(test::misnamedEquations(sentence, equationTable()), std::vector<std::string>{}) << sentence;
}

TEST(PaperEquations, OfCommentsAreReadThroughTheirLines)
{
  EXPECT_EQ(test::sentencesOfComments("/// One,\n/// two. Three.\nint a;  ///< four\n// at http://x\n"),
            (std::vector<std::string>{"One, two.", "Three. ", "four ", "at http://x "}));
}

}  // namespace
}  // namespace holdfast
