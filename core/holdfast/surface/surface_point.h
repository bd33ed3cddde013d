#pragma once
/// A point of the surface has a canonical form: the vertices that it hangs on, with weights, equations (4) to (6).

#include <vector>

#include <holdfast/numbers/term.h>

namespace holdfast {

/// A surface point is the sum of coefficient * p_index over vertices of the file. It is canonical: vertices ascend and
/// differ. Every coefficient (weight) is larger than `kVanishingWeight`, and a single term has the weight 1 exactly.
struct SurfacePoint {
  FewTerms terms;

  friend bool operator==(const SurfacePoint&, const SurfacePoint&) = default;
};

/// Weights up to this count as zero. Leaving one out moves the point by no more than this share of an edge. That is far
/// within the promised 1e-12 of the bounding box.
inline constexpr double kVanishingWeight = 1e-14;

/// Returns the canonical form of any terms whose weights sum to 1.
[[nodiscard]] SurfacePoint canonical(std::vector<Term> terms);

/// Returns the terms of x - y in the same form. There are none where both are one point: a single weight that is left
/// is rounding.
[[nodiscard]] std::vector<Term> difference(const SurfacePoint& x, const SurfacePoint& y);

[[nodiscard]] SurfacePoint midpoint(const SurfacePoint& x, const SurfacePoint& y);

/// Returns where the point is, in the units of `positions`.
[[nodiscard]] Vector3 positionOf(const SurfacePoint& point, const Positions& positions);

}  // namespace holdfast
