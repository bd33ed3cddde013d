#pragma once
/// \file
/// Fields of CSV texts as RFC 4180 has them.

#include <string>
#include <string_view>

namespace holdfast {

/// `text` as one field: in double quotes where it holds a comma, a quote, a line end, or blanks at an end.
[[nodiscard]] std::string csvField(std::string_view text);

}  // namespace holdfast
