#include "support/paper_equations.h"

#include <algorithm>
#include <cctype>
#include <regex>
#include <sstream>

namespace holdfast::test {
namespace {

std::string trimmed(std::string_view text)
{
  const auto isSpace = [](unsigned char c) { return std::isspace(c) != 0; };
  while (!text.empty() && isSpace(text.front())) text.remove_prefix(1);
  while (!text.empty() && isSpace(text.back())) text.remove_suffix(1);
  return std::string(text);
}

std::string lowered(std::string text)
{
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

std::vector<std::string> split(std::string_view text, char separator)
{
  std::vector<std::string> parts;
  std::istringstream stream{std::string(text)};
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(trimmed(part));
  return parts;
}

/// Paragraphs cut after a point that a capital letter, a parenthesis or a formula follows.
class Sentences {
 public:
  void add(std::string_view line) { paragraph_ += trimmed(line) + " "; }

  void endParagraph()
  {
    std::size_t from = 0;
    for (std::size_t k = 0; k + 2 < paragraph_.size(); ++k) {
      const auto next = static_cast<unsigned char>(paragraph_[k + 2]);
      const bool begins = std::isupper(next) != 0 || next == '(' || next == '`' || next == '*';
      if (paragraph_[k] != '.' || paragraph_[k + 1] != ' ' || !begins) continue;
      sentences_.push_back(paragraph_.substr(from, k + 1 - from));
      from = k + 2;
    }
    if (from < paragraph_.size()) sentences_.push_back(paragraph_.substr(from));
    paragraph_.clear();
  }

  [[nodiscard]] std::vector<std::string> take()
  {
    endParagraph();
    return std::move(sentences_);
  }

 private:
  std::string paragraph_;
  std::vector<std::string> sentences_;
};

struct Naming {
  int first;
  int last;
};

/// Numbers up to 99 in parentheses that follow a blank, and those after the word "equation".
std::vector<Naming> namings(const std::string& sentence)
{
  static const std::regex kPattern(R"((?:^|[\s/-])\(([1-9]\d?)\)|\b[Ee]q(?:uation)?s?\.?\s+([1-9]\d?)\b)");
  static const std::regex kRange(R"(\s*(?:to|-)\s*)");
  static const std::regex kPair(R"(\s*(?:,|and)\s*)");
  std::vector<Naming> result;
  std::size_t end = 0;
  bool isOpen = false;  // the last naming is a single number
  for (std::sregex_iterator match(sentence.begin(), sentence.end(), kPattern), none; match != none; ++match) {
    const int number = std::stoi((*match)[(*match)[1].matched ? 1 : 2].str());
    const auto begin = static_cast<std::size_t>(match->position());
    // The blank or dash that precedes a number belongs to what is between.
    const std::string between = isOpen ? sentence.substr(end, sentence.find('(', begin) - end) : "";
    if (isOpen &&
        (std::regex_match(between, kRange) || (number == result.back().last + 1 && std::regex_match(between, kPair)))) {
      result.back().last = number;
      isOpen = false;
    } else {
      result.push_back({number, number});
      isOpen = true;
    }
    end = begin + static_cast<std::size_t>(match->length());
  }
  return result;
}

const PaperEquations* find(const std::vector<PaperEquations>& table, Naming naming)
{
  for (const PaperEquations& row : table)
    if (row.first == naming.first && row.last == naming.last) return &row;
  return nullptr;
}

bool hasWordOf(const PaperEquations& row, const std::string& sentence)
{
  return std::any_of(row.words.begin(), row.words.end(), [&](const std::string& word) {
    return lowered(sentence).find(lowered(word)) != std::string::npos;
  });
}

void check(Naming naming, const std::string& sentence, const std::vector<PaperEquations>& table,
           std::vector<std::string>& mistakes)
{
  const std::string name = naming.first == naming.last
                               ? "(" + std::to_string(naming.first) + ")"
                               : "(" + std::to_string(naming.first) + ") to (" + std::to_string(naming.last) + ")";
  if (const PaperEquations* row = find(table, naming)) {
    if (!hasWordOf(*row, sentence)) mistakes.push_back(name + " is \"" + row->meaning + "\": " + sentence);
  } else if (naming.first >= naming.last) {
    mistakes.push_back(name + " is not in the table: " + sentence);
  } else {
    for (int number = naming.first; number <= naming.last; ++number) check({number, number}, sentence, table, mistakes);
  }
}

}  // namespace

std::vector<PaperEquations> paperEquations(std::string_view mathDocument)
{
  static const std::regex kNumber(R"(\((\d+)\))");
  static const std::regex kPlace(R"(`([a-z_/]+\.(?:h|cpp))`)");
  const std::size_t heading = mathDocument.find("\n## Equations of the paper\n");
  if (heading == std::string_view::npos) return {};
  const std::size_t end = mathDocument.find("\n## ", heading + 1);
  std::vector<PaperEquations> result;
  for (const std::string& line : split(mathDocument.substr(heading, end - heading), '\n')) {
    if (!line.starts_with("| (")) continue;
    const std::vector<std::string> cells = split(line.substr(1, line.size() - 2), '|');
    if (cells.size() != 4) continue;
    PaperEquations row{0, 0, cells[1], split(cells[2], ';'), {}};
    for (std::sregex_iterator match(cells[0].begin(), cells[0].end(), kNumber), none; match != none; ++match) {
      row.last = std::stoi((*match)[1].str());
      if (row.first == 0) row.first = row.last;
    }
    for (std::sregex_iterator match(cells[3].begin(), cells[3].end(), kPlace), none; match != none; ++match)
      row.places.push_back((*match)[1].str());
    result.push_back(std::move(row));
  }
  return result;
}

std::vector<std::string> sentencesOfComments(std::string_view source)
{
  Sentences sentences;
  for (const std::string& line : split(source, '\n')) {
    std::size_t start = line.find("//");
    while (start != std::string::npos && start > 0 && line[start - 1] == ':') start = line.find("//", start + 2);
    const std::size_t text = start == std::string::npos ? start : line.find_first_not_of("/<", start);
    // Comments of lines of their own go on; one behind code stands alone.
    const bool goesOn = start == 0 && text != std::string::npos;
    if (!goesOn) sentences.endParagraph();
    if (text != std::string::npos) sentences.add(line.substr(text));
    if (!goesOn) sentences.endParagraph();
  }
  return sentences.take();
}

std::vector<std::string> sentencesOfDocument(std::string_view markdown)
{
  Sentences sentences;
  bool isListing = false;
  for (const std::string& line : split(markdown, '\n')) {
    const bool isFence = line.starts_with("```");
    if (isFence || line.empty() || line.starts_with('|') || line.starts_with('#') || line.starts_with("* "))
      sentences.endParagraph();
    if (isFence) isListing = !isListing;
    if (!isListing && !isFence) sentences.add(line);
  }
  return sentences.take();
}

std::vector<std::string> misnamedEquations(const std::string& sentence, const std::vector<PaperEquations>& table)
{
  std::vector<std::string> mistakes;
  for (const Naming& naming : namings(sentence)) check(naming, sentence, table, mistakes);
  return mistakes;
}

std::size_t namedEquationCount(const std::string& sentence)
{
  return namings(sentence).size();
}

}  // namespace holdfast::test
