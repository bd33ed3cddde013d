#include "holdfast/io/text/base64.h"

#include <array>
#include <cassert>

namespace holdfast {
namespace {

constexpr std::string_view kBase64Letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::uint8_t kNoLetter = 64;

constexpr std::array<std::uint8_t, 256> kSextets = [] {
  std::array<std::uint8_t, 256> sextets{};
  sextets.fill(kNoLetter);
  for (std::size_t k = 0; k < kBase64Letters.size(); ++k)
    sextets[static_cast<unsigned char>(kBase64Letters[k])] = static_cast<std::uint8_t>(k);
  return sextets;
}();

/// The letters of three bytes, of which the last may be missing.
void addGroup(std::string& text, std::string_view bytes)
{
  std::uint32_t bits = 0;
  for (std::size_t k = 0; k < 3; ++k)
    bits = bits << 8U | (k < bytes.size() ? static_cast<unsigned char>(bytes[k]) : 0U);
  for (std::size_t k = 0; k < 4; ++k) text += k <= bytes.size() ? kBase64Letters[bits >> (18 - 6 * k) & 63U] : '=';
}

}  // namespace

std::string toBase64(std::string_view bytes)
{
  std::string text;
  text.reserve(base64Size(bytes.size()));
  for (std::size_t k = 0; k < bytes.size(); k += 3) addGroup(text, bytes.substr(k, 3));
  return text;
}

std::optional<std::string> fromBase64(std::string_view text, std::uint64_t count)
{
  assert(text.size() >= base64Size(count));
  std::string bytes;
  bytes.reserve(count);
  std::uint32_t bits = 0;
  for (std::size_t k = 0; bytes.size() < count; ++k) {
    const std::uint8_t sextet = kSextets[static_cast<unsigned char>(text[k])];
    if (sextet == kNoLetter) return std::nullopt;
    bits = bits << 6U | sextet;
    if (k % 4 != 0) bytes += static_cast<char>(bits >> (6 - 2 * (k % 4)));
  }
  return bytes;
}

}  // namespace holdfast
