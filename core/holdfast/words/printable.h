#pragma once
/// Messages are made of these: numbers of things, and text from outside (names, paths, options, messages of libraries)
/// as users see it.

#include <string>
#include <string_view>

#include <holdfast/numbers/types.h>

namespace holdfast {

/// Returns how many bytes the character of UTF-8 at the beginning of `text` has. Returns 0 where there is no valid one.
/// `text` must not be empty.
[[nodiscard]] std::size_t utf8Length(std::string_view text);

/// Returns `text` on one line, harmless to terminals. It writes some characters byte by byte as \xNN. These are control
/// characters, separators of lines and paragraphs, marks of the direction of writing, and bytes that are not UTF-8.
/// Beyond `most` bytes it cuts the text between characters and adds "...".
[[nodiscard]] std::string printable(std::string_view text, std::size_t most = std::string_view::npos);

/// The longest message: a path of the longest kind (4096 on Linux) and a reason.
inline constexpr std::size_t kLongestPrintedMessage = 6000;

/// Returns `printable(text)`, cut as names are: at 60 bytes.
[[nodiscard]] inline std::string shortened(std::string_view text)
{
  return printable(text, 60);
}

/// Returns `shortened(text)` in double quotes.
[[nodiscard]] inline std::string inQuotes(std::string_view text)
{
  return '"' + shortened(text) + '"';
}

/// Returns a count with its noun: "1 normal", "3 normals".
[[nodiscard]] inline std::string counted(Index count, const std::string& singular)
{
  return std::to_string(count) + " " + singular + (count == 1 ? "" : "s");
}

}  // namespace holdfast
