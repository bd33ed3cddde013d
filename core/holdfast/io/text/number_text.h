#pragma once
/// Numbers as text: read and written independently of the locale, so that a double survives to its last bit.

#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <string_view>

#include <holdfast/base/types.h>

namespace holdfast {

/// What messages call the numbers of a point.
inline constexpr std::array<std::string_view, 3> kCoordinateNames{"coordinate x", "coordinate y", "coordinate z"};

/// Why a token is not a number that can be held.
enum class NumberFault { None, NotANumber, OutOfRange };

/// `value` means something only where `fault` is `None`.
template <class Number>
struct ParsedNumber {
  Number value{};
  NumberFault fault = NumberFault::None;
};

/// The whole `token` as a decimal number, to the nearest double; a leading '+' is accepted, and so are "nan" and "inf"
/// in any case. A magnitude above the largest double or below half the smallest is `OutOfRange`.
[[nodiscard]] ParsedNumber<double> parseDouble(std::string_view token);

/// The whole `token` as a decimal integer; a leading '+' is accepted.
[[nodiscard]] ParsedNumber<Index> parseInteger(std::string_view token);

/// The shortest text that reads back as the same number.
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

/// Whether two doubles are the same to the last bit: -0.0 differs from 0.0, and a NaN is the same as itself.
[[nodiscard]] inline bool hasSameBits(double a, double b)
{
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

}  // namespace holdfast
