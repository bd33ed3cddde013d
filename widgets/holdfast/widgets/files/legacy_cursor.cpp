#include "holdfast/widgets/files/legacy_cursor.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include <holdfast/base/error.h>

namespace holdfast {
namespace {

/// VTK reads words into 256 characters.
constexpr std::size_t kLongestWord = 255;

constexpr std::string_view kLegacyBlanks = " \t\r\n\v\f";

/// Bits of one number in a binary block, by the name of its type in files.
constexpr std::array<std::pair<std::string_view, Index>, 16> kTypes{{{"bit", 1},
                                                                     {"char", 8},
                                                                     {"unsigned_char", 8},
                                                                     {"short", 16},
                                                                     {"unsigned_short", 16},
                                                                     {"int", 32},
                                                                     {"unsigned_int", 32},
                                                                     {"vtkidtype", 32},
                                                                     {"vtktypeint32", 32},
                                                                     {"float", 32},
                                                                     {"long", 64},
                                                                     {"unsigned_long", 64},
                                                                     {"vtktypeint64", 64},
                                                                     {"vtktypeuint64", 64},
                                                                     {"double", 64},
                                                                     {"string", 0}}};

/// What `text` says as a number of type `Number`, whole; false where it is none.
template <class Number>
bool isNumber(std::string_view text, Number& value)
{
  if (text.starts_with('+')) text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

}  // namespace

LegacyCursor::LegacyCursor(std::string_view bytes, std::string file) : bytes_(bytes), file_(std::move(file)) {}

void LegacyCursor::fail(const std::string& reason) const
{
  const std::string_view before = bytes_.substr(0, place_);
  if (isBinary_) throw InputError({file_, 0, "byte " + std::to_string(place_)}, reason);
  throw InputError({file_, std::count(before.begin(), before.end(), '\n') + 1, ""}, reason);
}

void LegacyCursor::skipBlanks()
{
  at_ = std::min(bytes_.find_first_not_of(kLegacyBlanks, at_), bytes_.size());
}

bool LegacyCursor::isAtEnd()
{
  skipBlanks();
  return at_ == bytes_.size();
}

std::string_view LegacyCursor::line()
{
  place_ = at_;
  const std::size_t end = std::min(bytes_.find('\n', at_), bytes_.size());
  std::string_view text = bytes_.substr(at_, end - at_);
  at_ = std::min(end + 1, bytes_.size());
  if (text.ends_with('\r')) text.remove_suffix(1);
  return text;
}

std::string_view LegacyCursor::rawWord()
{
  const bool isNoMore = isAtEnd();
  place_ = at_;
  if (isNoMore) fail("the file ends where more was announced; it was cut short, write it anew");
  const std::size_t end = std::min(bytes_.find_first_of(kLegacyBlanks, at_), bytes_.size());
  const std::string_view text = bytes_.substr(at_, end - at_);
  if (text.size() > kLongestWord) fail("a word of more than 255 characters; the file is damaged");
  at_ = end;
  return text;
}

std::string LegacyCursor::word()
{
  std::string text(rawWord());
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char letter) { return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter + 32) : letter; });
  return text;
}

std::string LegacyCursor::peekWord()
{
  if (isAtEnd()) return "";
  const std::size_t here = at_;
  std::string text = word();
  at_ = here;
  return text;
}

void LegacyCursor::requireWord(std::string_view expected)
{
  if (const std::string found = word(); found != expected)
    fail("'" + found + "' where '" + std::string(expected) + "' must stand");
}

Index LegacyCursor::count()
{
  const std::string_view text = rawWord();
  Index value = 0;
  if (!isNumber(text, value) || value < 0) fail("'" + std::string(text) + "' is no count; give a whole number from 0");
  return product(value, 1);
}

Index LegacyCursor::product(Index a, Index b) const
{
  if (a > 0 && b > limit() / a)
    fail("more data were announced than this file can hold; it is damaged or was cut short, write it anew");
  return a * b;
}

void LegacyCursor::requireBlankRestOfLine()
{
  if (line().find_first_not_of(kLegacyBlanks) != std::string_view::npos)
    fail("binary data must begin on a line of their own");
}

void LegacyCursor::skipBinary(Index size)
{
  if (size == 0) return;
  requireBlankRestOfLine();
  if (size > remaining())
    fail(std::to_string(size) + " bytes of data were announced, " + std::to_string(remaining()) +
         " are there; the file was cut short, write it anew");
  at_ += size;
}

void LegacyCursor::skipTextNumber()
{
  const std::string_view text = rawWord();
  double value = 0;
  if (!isNumber(text, value)) fail("'" + std::string(text) + "' is no number");
}

void LegacyCursor::skipNumbers(Index count, const std::string& type)
{
  const auto known = std::find_if(kTypes.begin(), kTypes.end(), [&](const auto& entry) { return entry.first == type; });
  if (known == kTypes.end()) fail("'" + type + "' is no type of numbers that can be read; use double, float or int");
  if (type == "string") return skipStrings(count);
  if (isBinary_) return skipBinary((count * known->second + 7) / 8);
  for (Index i = 0; i < count; ++i) skipTextNumber();
}

Index LegacyCursor::nextInt()
{
  if (!isBinary_) {
    const std::string_view text = rawWord();
    int value = 0;
    if (!isNumber(text, value)) fail("'" + std::string(text) + "' is no id");
    return value;
  }
  std::uint32_t value = 0;
  for (int i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes_[at_++]);
  return static_cast<std::int32_t>(value);
}

void LegacyCursor::skipCells(Index cellCount, Index size)
{
  if (isBinary_ && size > 0) {
    const std::size_t here = at_;
    skipBinary(4 * size);
    at_ = here;
    requireBlankRestOfLine();
  }
  Index left = size;
  for (Index cell = 0; cell < cellCount; ++cell) {
    const Index corners = left > 0 ? nextInt() : 0;
    left -= 1 + corners;
    if (corners < 0 || left < 0)
      fail("cell " + std::to_string(cell) + " does not fit in the " + std::to_string(size) + " numbers announced");
    for (Index i = 0; i < corners; ++i) (void)nextInt();
  }
  if (left != 0) fail(std::to_string(left) + " numbers more were announced than the cells take");
}

Index LegacyCursor::binaryStringLength()
{
  // The two highest bits of the first byte say how many bytes the length takes: 8, 4, 2 or 1.
  const auto first = remaining() > 0 ? static_cast<unsigned char>(bytes_[at_]) : 0U;
  const Index width = Index{8} >> (first >> 6U);
  if (width > remaining()) fail("the file ends in the length of a text; it was cut short, write it anew");
  Index length = first & 0x3FU;
  for (Index i = 1; i < width; ++i) length = length << 8 | static_cast<unsigned char>(bytes_[at_ + i]);
  at_ += width;
  if (length > remaining()) fail("a text is longer than what is left of the file; it was cut short, write it anew");
  return length;
}

void LegacyCursor::skipStrings(Index count)
{
  if (count == 0) return;
  (void)line();
  for (Index i = 0; i < count; ++i) {
    if (remaining() == 0) fail("the file ends where more texts were announced; it was cut short, write it anew");
    if (isBinary_)
      at_ += binaryStringLength();
    else
      (void)line();
  }
}

void LegacyCursor::skipParagraph()
{
  while (remaining() > 0 && line().find_first_not_of(kLegacyBlanks) != std::string_view::npos) {
  }
}

}  // namespace holdfast
