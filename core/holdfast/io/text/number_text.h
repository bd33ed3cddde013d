#pragma once
/// Numbers are read and written as text independently of the locale, so that a double survives to its last bit.

#include <array>
#include <charconv>
#include <string_view>
#include <system_error>

#include <holdfast/numbers/types.h>

namespace holdfast {

/// Messages call the numbers of a point by these names.
inline constexpr std::array<std::string_view, 3> kCoordinateNames{"coordinate x", "coordinate y", "coordinate z"};

enum class NumberFault { None, NotANumber, OutOfRange };

/// `value` means something only where `fault` is `None`.
template <class Number>
struct ParsedNumber {
  Number value{};
  NumberFault fault = NumberFault::None;
};

/// Reads the whole `token` as a decimal number, and accepts a leading '+'. The number is an integer or the nearest
/// double. "nan" and "inf" in any case are doubles too. A magnitude above the largest double or below half the smallest
/// is `OutOfRange`.
template <class Number>
[[nodiscard]] ParsedNumber<Number> parseNumber(std::string_view token)
{
  // std::from_chars knows no '+'; "+-1" must not slip through.
  if (token.size() > 1 && token[0] == '+' && token[1] != '-') token.remove_prefix(1);
  ParsedNumber<Number> parsed;
  const char* const end = token.data() + token.size();
  const auto [stop, error] = std::from_chars(token.data(), end, parsed.value);
  if (stop != end || token.empty() || error == std::errc::invalid_argument)
    parsed.fault = NumberFault::NotANumber;
  else if (error != std::errc{})
    parsed.fault = NumberFault::OutOfRange;
  return parsed;
}

/// Holds the shortest text that reads back as the same number.
class NumberText {
 public:
  template <class Number>
  explicit NumberText(Number value)
      : size_(std::to_chars(characters_.data(), characters_.data() + characters_.size(), value).ptr -
              characters_.data())
  {
  }

  [[nodiscard]] std::string_view view() const noexcept { return {characters_.data(), size_}; }

 private:
  std::array<char, 32> characters_{};  // a double takes 24 at most, an Index 20
  std::size_t size_ = 0;
};

}  // namespace holdfast
