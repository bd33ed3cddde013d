#pragma once
/// \file
/// Doubles that are no numbers.

#include <limits>

namespace holdfast::test {

inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace holdfast::test
