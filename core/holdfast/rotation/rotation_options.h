#pragma once
/// \file
/// These options say where the rotations of the surface come from.

#include <string_view>

namespace holdfast {

/// The rotations come from constraints, or are found with the shape.
enum class RotationSource {
  Given,       ///< they are the rotation field between those that constraints give, (25) to (29)
  Found,       ///< they are found with the shape, so that each edge keeps its length as nearly as it can
  FoundSmooth  ///< the same, and the detail is kept as well: the surface is smooth also beside a single point
};

/// Returns the name of the source in files and options: "given", "found", "found-smooth".
[[nodiscard]] std::string_view name(RotationSource source);

/// Returns the name of the length of which `RotationOptions::change` is a share: "diagonal", or "diameter" with
/// `FoundSmooth`.
[[nodiscard]] std::string_view sizeName(RotationSource source);

/// The default of `RotationOptions::change`. Where a picture of 2,000 pixels shows the whole mesh, this is a fiftieth
/// of a pixel. A vertex that moves by less does not move there. What is left to go is some ten to a hundred times the
/// last change.
inline constexpr double kFoundChange = 1e-5;

/// The default of `RotationOptions::mostIterations`. Where more iterations are needed, a local minimum is as flat as
/// rounding, or there is none.
inline constexpr int kMostIterations = 1000;

/// The source of the rotations, and when rotations that are found are good enough.
///
///     DeformOptions options;
///     options.rotations.source = RotationSource::FoundSmooth;
///     options.rotations.change = 1e-4;  // a preview
///     const DeformResult result = deform(model, constraints, "constraints", options);
struct RotationOptions {
  RotationSource source = RotationSource::Given;
  /// Rotations that are found are good enough when an iteration moves no vertex by more than this share of the diagonal
  /// of the bounding box. With `FoundSmooth` it is a share of the diameter of the smallest sphere around the mesh. No
  /// iteration reaches a negative share. What is not reached within `mostIterations` ends with
  /// `RotationIterations::isConverged` false.
  double change = kFoundChange;
  int mostIterations = kMostIterations;

  friend bool operator==(const RotationOptions&, const RotationOptions&) = default;
};

}  // namespace holdfast
