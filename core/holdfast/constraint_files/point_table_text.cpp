#include <algorithm>
#include <cmath>

#include <holdfast/constraint_files/point_table_format_internal.h>
#include <holdfast/words/lower_case.h>

namespace holdfast {
namespace {

// They stand between digits and their units, and between groups of digits.
constexpr std::array<std::string_view, 5> kUnbreakable{"\u00A0", "\u2007", "\u2009", "\u202F", "\uFEFF"};
constexpr std::string_view kMinusSign = "\u2212";

constexpr std::array<std::string_view, 14> kUnits{"mm", "cm", "dm",   "m",      "km", "um",  "\u00B5m",
                                                  "nm", "in", "inch", "inches", "ft", "mil", "\u03BCm"};

bool isDigit(char c)
{
  return c >= '0' && c <= '9';
}

/// Bytes of the blank that does not break at the beginning of `text`; 0 where there is none.
std::size_t unbreakableLength(std::string_view text)
{
  for (const std::string_view blank : kUnbreakable)
    if (text.starts_with(blank)) return blank.size();
  return 0;
}

std::size_t blankLength(std::string_view text)
{
  if (text.starts_with(' ') || text.starts_with('\t')) return 1;
  return unbreakableLength(text);
}

/// Tells whether exactly three digits begin `text`.
bool beginsWithGroup(std::string_view text)
{
  const auto end = std::find_if_not(text.begin(), text.end(), isDigit);
  return end - text.begin() == 3;
}

/// `digits` with a plain minus, and without unbreakable blanks between groups of three digits.
std::string plainDigits(std::string_view digits)
{
  std::string plain;
  while (!digits.empty()) {
    const std::size_t blank = unbreakableLength(digits);
    const bool isGroup = blank > 0 && !plain.empty() && isDigit(plain.back()) && beginsWithGroup(digits.substr(blank));
    if (digits.starts_with(kMinusSign)) {
      plain += '-';
      digits.remove_prefix(kMinusSign.size());
    } else if (isGroup) {
      digits.remove_prefix(blank);
    } else {
      plain += digits.front();
      digits.remove_prefix(1);
    }
  }
  return plain;
}

bool isUnit(std::string_view word)
{
  return std::ranges::count(kUnits, word) != 0;
}

bool isWordLetter(char c)
{
  return (c >= 'a' && c <= 'z') || isDigit(c) || static_cast<unsigned char>(c) >= 0x80;
}

/// Lower case, with plain blanks.
std::string plainText(std::string_view text)
{
  std::string plain;
  while (!text.empty()) {
    const std::size_t blank = unbreakableLength(text);
    plain += blank > 0 ? ' ' : lowerCase(text.front());
    text.remove_prefix(std::max<std::size_t>(blank, 1));
  }
  return plain;
}

std::vector<std::string> wordsOf(std::string_view text)
{
  std::vector<std::string> words;
  bool isOpen = false;
  for (const char c : text) {
    if (isWordLetter(c) && !isOpen) words.emplace_back();
    isOpen = isWordLetter(c);
    if (isOpen) words.back() += c;
  }
  return words;
}

/// Takes a unit off the end: "x mm", "x/mm", "x in mm".
std::string takenUnit(std::vector<std::string>& words)
{
  if (words.size() < 2 || !isUnit(words.back())) return "";
  std::string unit = std::move(words.back());
  words.pop_back();
  if (words.size() > 1 && words.back() == "in") words.pop_back();
  return unit;
}

/// Takes what stands in brackets off the end; it is the unit if it is one.
std::string takenBrackets(std::string& text)
{
  const std::size_t begin = text.find_first_of("[(");
  if (begin == std::string::npos || begin == 0) return "";
  const std::vector<std::string> inside = wordsOf(std::string_view(text).substr(begin));
  text.resize(begin);
  return inside.size() == 1 && isUnit(inside[0]) ? inside[0] : "";
}

/// The separator of a line such as "sep=;", which spreadsheets write before a table.
std::optional<char> statedSeparator(std::string_view line)
{
  std::string text = lowerCase(std::string(line));
  std::erase(text, '"');
  constexpr std::string_view kKey = "sep=";
  if (!text.starts_with(kKey) || text.size() != kKey.size() + 1 || isWordLetter(text.back())) return std::nullopt;
  return text.back();
}

std::size_t commentMarker(std::string_view line)
{
  return line.starts_with("//") ? 2 : line.starts_with('#') ? 1 : 0;
}

/// Bytes of the end of a line at the beginning of `text`.
std::size_t lineEndLength(std::string_view text)
{
  if (text.empty()) return 0;
  return text.starts_with("\r\n") ? 2 : 1;
}

}  // namespace

std::string_view withoutBlanks(std::string_view field)
{
  while (const std::size_t length = blankLength(field)) field.remove_prefix(length);
  const auto lastBlank = [&]() -> std::size_t {
    if (field.ends_with(' ') || field.ends_with('\t')) return 1;
    for (const std::string_view blank : kUnbreakable)
      if (field.ends_with(blank)) return blank.size();
    return 0;
  };
  while (const std::size_t length = lastBlank()) field.remove_suffix(length);
  return field;
}

ParsedNumber<double> numberInField(std::string_view field, char decimalSign)
{
  std::string digits = plainDigits(withoutBlanks(field));
  if (decimalSign == ',') {
    if (digits.find('.') != std::string::npos) return {0, NumberFault::NotANumber};
    std::ranges::replace(digits, ',', '.');
  }
  ParsedNumber<double> number = parseNumber<double>(digits);
  if (number.fault == NumberFault::None && !std::isfinite(number.value)) number.fault = NumberFault::NotANumber;
  return number;
}

ColumnTitle partsOf(std::string_view title)
{
  std::string text = plainText(withoutBlanks(title));
  ColumnTitle parts{"", takenBrackets(text)};
  std::vector<std::string> words = wordsOf(text);
  if (parts.unit.empty()) parts.unit = takenUnit(words);
  for (const std::string& word : words) parts.key += word;
  return parts;
}

std::string unitIn(std::string_view field)
{
  const std::vector<std::string> words = wordsOf(plainText(field));
  return words.size() == 1 && isUnit(words[0]) ? words[0] : "";
}

TablePreamble preambleOf(std::string_view text)
{
  TablePreamble preamble;
  while (preamble.size < text.size()) {
    const std::string_view rest = text.substr(preamble.size);
    const std::string_view line = rest.substr(0, rest.find_first_of("\r\n"));
    const std::string_view content = withoutBlanks(line);
    const std::size_t marker = commentMarker(content);
    if (const auto separator = statedSeparator(content)) {
      preamble.separator = separator;
    } else if (marker > 0) {
      const std::string_view said = content.substr(marker);
      if (isHeaderLine(said)) {
        preamble.size += static_cast<std::size_t>(said.data() - rest.data());
        return preamble;
      }
      // "#1,0,0,0" is a row of a point that is called so.
      if (!said.empty() && blankLength(said) == 0 && isRowLine(content)) return preamble;
    } else if (!content.empty()) {
      return preamble;
    }
    preamble.size += line.size() + lineEndLength(rest.substr(line.size()));
    ++preamble.lines;
  }
  return preamble;
}

}  // namespace holdfast
