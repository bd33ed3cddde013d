#pragma once
/// What messages are made of: text from outside (names, paths, options, messages of libraries) as users see it, and
/// numbers of things.

#include <string>
#include <string_view>

#include <holdfast/base/types.h>

namespace holdfast {

/// Bytes of the character of UTF-8 at the beginning of `text`, which is not empty; 0 where there is no valid one.
[[nodiscard]] std::size_t utf8Length(std::string_view text);

/// `text` on one line, harmless to terminals: control characters, separators of lines and paragraphs, marks of the
/// direction of writing and bytes that are not UTF-8 are written byte by byte as \xNN. Beyond `most` bytes it is cut
/// between characters, and "..." follows.
[[nodiscard]] std::string printable(std::string_view text, std::size_t most = std::string_view::npos);

/// The longest message: a path of the longest kind (4096 on Linux) and a reason.
inline constexpr std::size_t kLongestPrintedMessage = 6000;

/// `printable`, cut as names are: at 60 bytes.
[[nodiscard]] inline std::string shortened(std::string_view text)
{
  return printable(text, 60);
}

/// The same in double quotes.
[[nodiscard]] inline std::string inQuotes(std::string_view text)
{
  return '"' + shortened(text) + '"';
}

/// "1 normal", "3 normals".
[[nodiscard]] inline std::string counted(Index count, const std::string& singular)
{
  return std::to_string(count) + " " + singular + (count == 1 ? "" : "s");
}

}  // namespace holdfast
