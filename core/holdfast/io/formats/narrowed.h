#pragma once
/// Counts in files with 32-bit numbers.

#include <limits>
#include <string>

#include <fmt/format.h>

#include <holdfast/base/error.h>

namespace holdfast {

/// Throws `OutputError` where `count` is more than a file with 32-bit numbers can say.
template <class Number>
[[nodiscard]] Number narrowed(Index count, const std::string& extension)
{
  if (count > static_cast<Index>(std::numeric_limits<Number>::max()))
    throw OutputError(extension, fmt::format("{} is more than the 32-bit numbers of this format can count: write OBJ "
                                             "or OFF",
                                             count));
  return static_cast<Number>(count);
}

}  // namespace holdfast
