#pragma once
/// Vertices and their partners across a plane.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include <holdfast/constraints/constraint.h>

namespace holdfast {

/// A vertex may be as far from the image of its partner as this share of the diagonal, unless the constraint says
/// otherwise.
inline constexpr double kMirrorTolerance = 1e-6;

/// The partners of some places across a plane.
struct MirrorPairs {
  std::vector<std::array<Index, 2>> pairs;  ///< the smaller place first, each pair once, ascending
  std::vector<Index> onPlane;               ///< those that are their own partners, ascending
  std::vector<Index> unpaired;              ///< ascending
};

/// Finds the partners of `wanted` among all `places` (n x 3, finite). Two places are partners where each is the nearest
/// to the image of the other, within `tolerance` (model units). `normal` is not zero. O(n log n).
[[nodiscard]] MirrorPairs mirrorPairs(const Positions& places, std::span<const Index> wanted, const Vector3& point,
                                      const Vector3& normal, double tolerance);

/// Returns a plane across a coordinate axis, through the middle of `places` or through 0, across which most of them
/// have partners. Returns nothing where fewer than half have. O(n log n).
[[nodiscard]] std::optional<MirrorConstraint> symmetryOf(const Positions& places, double tolerance);

}  // namespace holdfast
