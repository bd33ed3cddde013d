#pragma once
/// \file
/// Pictures against the ones that are known to be right.

#include <filesystem>
#include <functional>
#include <string>

#include <holdfast/widgets/scene/scene.h>

class vtkCamera;

namespace holdfast::test {

/// A PNG file of three channels; no pixels where it is none.
[[nodiscard]] Picture readPng(const std::filesystem::path& path);

/// The share of pixels that differ by more than 10 of 255 in any channel; 1 where the sizes differ.
[[nodiscard]] double shareOfOtherPixels(const Picture& a, const Picture& b);

/// Pictures with a larger share of other pixels are not the same: processors round differently at edges. Renderers
/// differ by more, where a line is hidden by half, and have baselines of their own.
inline constexpr double kLargestShareOfOtherPixels = 1e-4;

/// Empty where `picture` is a baseline of the running test: baselines/SUITE.TEST.png, or, of another renderer,
/// baselines/RENDERER/SUITE.TEST.png. Else, and where there is no baseline, what is wrong and where the picture has
/// been written to.
[[nodiscard]] std::string differenceFromBaseline(const Picture& picture);

/// The same for what `draw` draws; and the control: not empty either where a baseline passes for the picture that
/// `camera`, turned by a tenth of a degree, gives.
[[nodiscard]] std::string differenceFromBaseline(vtkCamera& camera, const std::function<Picture()>& draw);

}  // namespace holdfast::test
