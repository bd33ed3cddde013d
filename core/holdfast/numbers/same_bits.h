#pragma once
/// Compares doubles bit by bit.

#include <bit>
#include <cstdint>

namespace holdfast {

/// Tells whether two doubles are the same to the last bit. -0.0 differs from 0.0, and a NaN is the same as itself.
[[nodiscard]] inline bool hasSameBits(double a, double b)
{
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

}  // namespace holdfast
