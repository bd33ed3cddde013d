#pragma once
/// \file
/// Constraint files that show what rotations do, as text.

#include <string>

namespace holdfast::generate {

/// One end of the bar stays, the other makes `degrees` about its length.
[[nodiscard]] std::string twistedBar(double degrees);

/// Two discs of the plate turn about different axes and nothing is fixed.
[[nodiscard]] std::string plateBetweenTwoHandles();

/// The same with three discs.
[[nodiscard]] std::string plateBetweenThreeHandles();

/// The head leans to its right; its eyes are rigid, and the vector from mouth to nose only turns.
[[nodiscard]] std::string leaningHead();

}  // namespace holdfast::generate
