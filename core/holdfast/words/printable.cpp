#include "holdfast/words/printable.h"

#include <algorithm>
#include <array>
#include <bit>

#include <fmt/format.h>

namespace holdfast {
namespace {

struct Utf8Character {
  char32_t code = 0;
  std::size_t length = 0;  ///< in bytes; 0 where there is none
};

/// At the beginning of `text`, which is not empty. Overlong forms, surrogates and code points past U+10FFFF are none.
Utf8Character firstUtf8Character(std::string_view text)
{
  constexpr std::array<char32_t, 5> kLeast{0, 0, 0x80, 0x800, 0x10000};  // of so many bytes
  const auto lead = static_cast<unsigned char>(text[0]);
  const std::size_t length = std::max(1, std::countl_one(lead));
  if ((lead >= 0x80 && length == 1) || length > 4 || length > text.size()) return {};
  char32_t code = length == 1 ? lead : lead & (0x7FU >> length);
  for (const char byte : text.substr(1, length - 1)) {
    if ((static_cast<unsigned char>(byte) & 0xC0U) != 0x80U) return {};
    code = code << 6U | (static_cast<unsigned char>(byte) & 0x3FU);
  }
  if (code < kLeast[length] || code > 0x10FFFF || (code >= 0xD800 && code <= 0xDFFF)) return {};
  return {code, length};
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
  return firstUtf8Character(text).length;
}

std::string printable(std::string_view text, std::size_t most)
{
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const auto [code, length] = firstUtf8Character(text.substr(at));
    const std::string_view character = text.substr(at, std::max<std::size_t>(1, length));
    if (character.size() > most - at) return result + "...";
    at += character.size();
    if (length > 0 && isForPrinting(code))
      result += character;
    else
      for (const char byte : character) result += fmt::format("\\x{:02x}", static_cast<unsigned char>(byte));
  }
  return result;
}

}  // namespace holdfast
