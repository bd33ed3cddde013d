#pragma once
/// \file
/// Where the rotations of the surface come from.

#include <string_view>

namespace holdfast {

enum class RotationSource {
  Given,       ///< the rotation field of those that constraints give, (25) to (29)
  Found,       ///< found with the shape: each edge is to keep its length
  FoundSmooth  ///< the same, and the detail is kept as well: smooth also beside a single point
};

/// The name in files and options: "given", "found", "found-smooth".
[[nodiscard]] std::string_view name(RotationSource source);

/// What the length is called that changes of found rotations are a share of: "diagonal", or "diameter".
[[nodiscard]] std::string_view sizeName(RotationSource source);

/// A picture of 2,000 pixels shows the whole mesh; a vertex that moves by less than a fiftieth of a pixel does not move
/// there. What is left to go is some ten to a hundred times the last change.
inline constexpr double kFoundChange = 1e-5;

/// Where rotations are found beyond this, a local minimum is as flat as rounding, or there is none.
inline constexpr int kMostIterations = 1000;

struct RotationOptions {
  RotationSource source = RotationSource::Given;
  /// Rotations that are found are good enough when an iteration moves no vertex by more than this share of the diagonal
  /// of the bounding box; with `FoundSmooth` of the diameter of the smallest sphere.
  double change = kFoundChange;
  int mostIterations = kMostIterations;

  friend bool operator==(const RotationOptions&, const RotationOptions&) = default;
};

}  // namespace holdfast
