#pragma once
/// Letters of ASCII in lower case, whatever the locale. Other bytes stay as they are.

#include <algorithm>
#include <string>

namespace holdfast {

[[nodiscard]] constexpr char lowerCase(char c) noexcept
{
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

[[nodiscard]] inline std::string lowerCase(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(), [](char c) { return lowerCase(c); });
  return text;
}

}  // namespace holdfast
