#pragma once
/// \file
/// Values as JSON text that reads back as the same values.

#include <string>
#include <string_view>

#include <holdfast/base/types.h>

namespace holdfast {

/// In double quotes, with quotes, backslashes and control characters escaped. `text` is UTF-8.
[[nodiscard]] std::string textJson(std::string_view text);

/// The shortest text of the double, -0.0 included. What is not finite becomes null: JSON cannot say it.
[[nodiscard]] std::string numberJson(double value);

[[nodiscard]] std::string numberJson(Index value);

/// [x, y, z].
[[nodiscard]] std::string vectorJson(const Vector3& v);

/// A list of `elementJson` of every element, in one line.
template <class Range, class Function>
[[nodiscard]] std::string listJson(const Range& range, Function elementJson)
{
  std::string json;
  for (const auto& element : range) {
    json += json.empty() ? "[" : ", ";
    json += elementJson(element);
  }
  return json.empty() ? "[]" : json + "]";
}

}  // namespace holdfast
