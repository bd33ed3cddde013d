#pragma once
/// These functions write bytes as base64 text and read such text (RFC 4648, section 4).

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace holdfast {

/// Returns how many letters `count` bytes take, those that fill the last group included.
[[nodiscard]] constexpr std::uint64_t base64Size(std::uint64_t count)
{
  return (count + 2) / 3 * 4;
}

/// Returns the text of `bytes`. O(bytes).
[[nodiscard]] std::string toBase64(std::string_view bytes);

/// Returns the first `count` bytes that `text` says. `text` has the letters of at least so many. There are none where
/// one of these letters is not of the alphabet. O(count).
[[nodiscard]] std::optional<std::string> fromBase64(std::string_view text, std::uint64_t count);

}  // namespace holdfast
