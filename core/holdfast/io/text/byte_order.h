#pragma once
/// Numbers as bytes of either order.

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <string_view>

namespace holdfast {

enum class ByteOrder { kLittle, kBig };

/// The bytes of one number.
template <class Number>
struct NumberBytes {
  std::array<char, sizeof(Number)> bytes{};

  [[nodiscard]] std::string_view view() const noexcept { return {bytes.data(), bytes.size()}; }
};

/// `value` as bytes of the given order.
template <class Number>
[[nodiscard]] NumberBytes<Number> toBytes(Number value, ByteOrder order)
{
  static_assert(std::endian::native == std::endian::little || std::endian::native == std::endian::big);
  NumberBytes<Number> result{std::bit_cast<std::array<char, sizeof(Number)>>(value)};
  const bool isNative = (order == ByteOrder::kLittle) == (std::endian::native == std::endian::little);
  if (!isNative) std::reverse(result.bytes.begin(), result.bytes.end());
  return result;
}

/// The number whose bytes of the given order are `bytes`, exactly as many as it has.
template <class Number>
[[nodiscard]] Number fromBytes(std::string_view bytes, ByteOrder order)
{
  assert(bytes.size() == sizeof(Number));
  std::array<char, sizeof(Number)> native{};
  std::copy_n(bytes.begin(), native.size(), native.begin());
  const bool isNative = (order == ByteOrder::kLittle) == (std::endian::native == std::endian::little);
  if (!isNative) std::reverse(native.begin(), native.end());
  return std::bit_cast<Number>(native);
}

}  // namespace holdfast
