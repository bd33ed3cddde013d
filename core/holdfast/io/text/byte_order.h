#pragma once
/// Numbers as bytes of either order.

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <string>
#include <string_view>

namespace holdfast {

enum class ByteOrder { kLittle, kBig };

/// Whether numbers in memory have this order.
[[nodiscard]] constexpr bool isNative(ByteOrder order) noexcept
{
  static_assert(std::endian::native == std::endian::little || std::endian::native == std::endian::big);
  return (order == ByteOrder::kLittle) == (std::endian::native == std::endian::little);
}

template <class Number>
[[nodiscard]] std::string toBytes(Number value, ByteOrder order)
{
  const auto bytes = std::bit_cast<std::array<char, sizeof(Number)>>(value);
  return isNative(order) ? std::string(bytes.begin(), bytes.end()) : std::string(bytes.rbegin(), bytes.rend());
}

/// Of exactly as many bytes as the number has.
template <class Number>
[[nodiscard]] Number fromBytes(std::string_view bytes, ByteOrder order)
{
  assert(bytes.size() == sizeof(Number));
  std::array<char, sizeof(Number)> native{};
  std::copy_n(bytes.begin(), native.size(), native.begin());
  if (!isNative(order)) std::reverse(native.begin(), native.end());
  return std::bit_cast<Number>(native);
}

}  // namespace holdfast
