#pragma once
/// \file
/// Text that came from outside (names, paths, values of options, messages of libraries) as people are shown it.

#include <string>
#include <string_view>

namespace holdfast {

/// Bytes of the character of UTF-8 at the beginning of `text`, which is not empty; 0 where there is no valid one.
[[nodiscard]] std::size_t utf8Length(std::string_view text);

/// `text` on one line, harmless to terminals: what is not for printing (control characters, separators of lines and
/// paragraphs, marks that turn the direction of writing, bytes that are not UTF-8) is written byte by byte as \xNN. Of
/// more than `most` bytes the first are taken, whole characters, and "..." follows. Text that is printable and not
/// too long stays as it is.
[[nodiscard]] std::string printable(std::string_view text, std::size_t most = std::string_view::npos);

/// Of a whole message: a path of the longest kind (4096 on Linux) and what is wrong with it.
inline constexpr std::size_t kLongestPrintedMessage = 6000;

/// `printable`, cut as names are: at 60 bytes.
[[nodiscard]] std::string shortened(std::string_view text);

/// The same in double quotes.
[[nodiscard]] std::string inQuotes(std::string_view text);

}  // namespace holdfast
