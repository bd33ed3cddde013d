#pragma once
/// \file
/// What tolerances of rounding are multiples of.

#include <limits>

namespace holdfast::test {

inline constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

}  // namespace holdfast::test
