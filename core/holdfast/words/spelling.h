#pragma once
/// Words that were spelled wrong.

#include <optional>
#include <span>
#include <string_view>

namespace holdfast {

/// Returns the word of `known` that `word` was probably meant to be. Letter case aside, about one letter in three may
/// differ.
[[nodiscard]] std::optional<std::string_view> closestSpelling(std::string_view word,
                                                              std::span<const std::string_view> known);

}  // namespace holdfast
