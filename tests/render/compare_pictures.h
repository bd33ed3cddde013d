#pragma once
/// \file
/// Pictures against the ones that are known to be right.

#include <string>

#include <holdfast/view/snapshot.h>

namespace holdfast::test {

/// The share of pixels that differ by more than 10 of 255 in any channel; 1 where the sizes differ.
[[nodiscard]] double shareOfOtherPixels(const Picture& a, const Picture& b);

/// Pictures with a larger share of other pixels are not the same. Renderers round differently at edges; a camera
/// turned by a tenth of a degree changes six times as many.
inline constexpr double kLargestShareOfOtherPixels = 1e-4;

/// Empty where `picture` is the baseline of the running test, tests/render/baselines/SUITE.TEST.png. Else, and where
/// there is no such baseline, what is wrong and where the picture has been written to.
[[nodiscard]] std::string differenceFromBaseline(const Picture& picture);

}  // namespace holdfast::test
