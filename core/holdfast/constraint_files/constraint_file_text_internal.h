#pragma once
/// Text as constraint files and point lists need it: UTF-8, and words for messages.

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <holdfast/base/printable.h>
#include <holdfast/base/types.h>

namespace holdfast {

/// A place in a text: line and column from 1, the column in bytes.
struct TextPlace {
  Index line = 1;
  Index column = 1;
};

/// The place of byte `offset`; of the end where `offset` is past it. O(offset).
[[nodiscard]] TextPlace placeInText(std::string_view text, std::size_t offset);

/// Whether the name says that the file is a point list: it ends in .csv, in any case of letters.
[[nodiscard]] bool isPointList(const std::filesystem::path& path);

/// `text` without a byte order mark. Throws `InputError` with the line of the first byte that is not UTF-8.
[[nodiscard]] std::string_view requireUtf8(std::string_view text, std::string_view file);

/// "a", "b", "c".
[[nodiscard]] std::string listInQuotes(std::span<const std::string_view> words);

/// The word of `known` that `word` was probably meant to be: letter case aside, about one letter in three may differ.
[[nodiscard]] std::optional<std::string_view> closestSpelling(std::string_view word,
                                                              std::span<const std::string_view> known);

/// `; did you mean "center"? Known here: "axis", "center"`, the end of a message about an unknown word.
[[nodiscard]] std::string spellingHint(std::string_view word, std::span<const std::string_view> known);

}  // namespace holdfast
