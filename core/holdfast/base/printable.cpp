#include "holdfast/base/printable.h"

#include <fmt/format.h>

namespace holdfast {
namespace {

unsigned char byteAt(std::string_view text, std::size_t place)
{
  return static_cast<unsigned char>(text[place]);
}

std::size_t lengthFromLead(unsigned char lead)
{
  if (lead < 0x80) return 1;
  if (lead >= 0xC2 && lead <= 0xDF) return 2;
  if (lead >= 0xE0 && lead <= 0xEF) return 3;
  if (lead >= 0xF0 && lead <= 0xF4) return 4;
  return 0;
}

/// Overlong forms, surrogates and code points past U+10FFFF show in the second byte (Unicode, table 3-7).
bool isSecondByteAllowed(unsigned char lead, unsigned char second)
{
  if (lead == 0xE0) return second >= 0xA0;
  if (lead == 0xED) return second <= 0x9F;
  if (lead == 0xF0) return second >= 0x90;
  return lead != 0xF4 || second <= 0x8F;
}

/// `character` is valid.
char32_t codePointOf(std::string_view character)
{
  if (character.size() == 1) return byteAt(character, 0);
  char32_t code = byteAt(character, 0) & (0x7FU >> character.size());
  for (std::size_t i = 1; i < character.size(); ++i) code = code << 6U | (byteAt(character, i) & 0x3FU);
  return code;
}

bool isForPrinting(char32_t c)
{
  const bool isControl = c < 0x20 || (c >= 0x7F && c < 0xA0);
  const bool separates = c == 0x2028 || c == 0x2029;
  const bool turnsDirection =
      c == 0x061C || c == 0x200E || c == 0x200F || (c >= 0x202A && c <= 0x202E) || (c >= 0x2066 && c <= 0x2069);
  return !isControl && !separates && !turnsDirection;
}

}  // namespace

std::size_t utf8Length(std::string_view text)
{
  const std::size_t length = lengthFromLead(byteAt(text, 0));
  if (length == 0 || length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byteAt(text, i) & 0xC0U) != 0x80U) return 0;
  return length == 1 || isSecondByteAllowed(byteAt(text, 0), byteAt(text, 1)) ? length : 0;
}

std::string printable(std::string_view text, std::size_t most)
{
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t valid = utf8Length(text.substr(at));
    const std::string_view character = text.substr(at, valid == 0 ? 1 : valid);
    if (character.size() > most - at) return result + "...";
    at += character.size();
    if (valid > 0 && isForPrinting(codePointOf(character)))
      result += character;
    else
      for (const char byte : character) result += fmt::format("\\x{:02x}", static_cast<unsigned char>(byte));
  }
  return result;
}

}  // namespace holdfast
