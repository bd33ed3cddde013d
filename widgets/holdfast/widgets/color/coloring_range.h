#pragma once
/// \file
/// Which values take the colours of a map: those that suit the values, or those that a user asks for.

#include <variant>

#include <holdfast/widgets/color/coloring.h>

namespace holdfast {

/// The range that a colouring has by itself.
struct AutomaticRange {};

/// From one value to another: two pictures of one range can be compared.
struct FixedRange {
  double low = 0;
  double high = 1;
};

/// Powers of ten from that above the largest value down by `decades`, 1 or more.
struct LogarithmicRange {
  int decades = 4;
};

using ColorRange = std::variant<AutomaticRange, FixedRange, LogarithmicRange>;

/// Why there is no such range, in a sentence that says what to do; empty where there is one.
[[nodiscard]] std::string whyNoRange(const ColorRange& range);

/// `coloring` over `range`, for which `whyNoRange` is empty. A fixed range stays on the scale, linear or logarithmic,
/// that there was, and is linear where it does not begin above 0. A logarithmic one of values none of which is larger
/// than 0 changes nothing. Only the scale changes, never the values. O(N).
[[nodiscard]] Coloring withRange(Coloring coloring, const ColorRange& range);

}  // namespace holdfast
