#pragma once
/// \file
/// The equations of the paper as docs/math.md lists them, and where texts name them.

#include <string>
#include <string_view>
#include <vector>

namespace holdfast::test {

/// A row of the table: equations `first` to `last`, and words of which one stands wherever they are named.
struct PaperEquations {
  int first = 0;
  int last = 0;
  std::string meaning;
  std::vector<std::string> words;
  std::vector<std::string> places;  ///< files below core/holdfast/
};

/// The table under "Equations of the paper".
[[nodiscard]] std::vector<PaperEquations> paperEquations(std::string_view mathDocument);

/// The sentences of a source's comments, or of a Markdown document without its listings. Lines of tables are sentences.
[[nodiscard]] std::vector<std::string> sentencesOfComments(std::string_view source);
[[nodiscard]] std::vector<std::string> sentencesOfDocument(std::string_view markdown);

/// What is wrong with the equations that `sentence` names, by numbers in parentheses or after the word "equation",
/// alone or as ranges: the table has no such number, or the sentence has none of its words. A range that is no row of
/// the table has to have a word of each number.
[[nodiscard]] std::vector<std::string> misnamedEquations(const std::string& sentence,
                                                         const std::vector<PaperEquations>& table);

/// How many equations and ranges a sentence names.
[[nodiscard]] std::size_t namedEquationCount(const std::string& sentence);

}  // namespace holdfast::test
