#pragma once
/// These functions turn numbers into bytes of either order, and back.

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <string>
#include <string_view>

namespace holdfast {

template <class Number>
[[nodiscard]] std::string toBytes(Number value, std::endian order)
{
  const auto bytes = std::bit_cast<std::array<char, sizeof(Number)>>(value);
  return order == std::endian::native ? std::string(bytes.begin(), bytes.end())
                                      : std::string(bytes.rbegin(), bytes.rend());
}

/// Returns the number that `bytes` hold. They are exactly as many as the number has.
template <class Number>
[[nodiscard]] Number fromBytes(std::string_view bytes, std::endian order)
{
  assert(bytes.size() == sizeof(Number));
  std::array<char, sizeof(Number)> native{};
  std::copy_n(bytes.begin(), native.size(), native.begin());
  if (order != std::endian::native) std::reverse(native.begin(), native.end());
  return std::bit_cast<Number>(native);
}

}  // namespace holdfast
