#pragma once
/// Degrees, for what people read and write; all else counts in radians.

#include <numbers>

namespace holdfast {

/// A degree in radians.
inline constexpr double kDegree = std::numbers::pi / 180;

}  // namespace holdfast
