#pragma once
/// \file
/// Triangulation of plane regions by triangles that are as equilateral as the boundary lets them be.

#include <functional>

#include "delaunay.h"

namespace holdfast::generate {

/// The wanted edge length at a place.
using SizeFunction = std::function<double(const Vector2&)>;

/// Points and anticlockwise triangles. The first points are the corners of the loops, in order.
struct Region {
  std::vector<Vector2> points;
  std::vector<Triangle> triangles;
};

/// The edge lengths of the loops, growing by `growth` a unit of distance towards the inside, at most `largest`.
[[nodiscard]] SizeFunction sizeFromBoundary(const std::vector<Loop>& loops, double growth, double largest);

/// Fills the region between `loops` (see `Delaunay`). The frontal Delaunay method of S. Rebay, "Efficient unstructured
/// mesh generation by means of Delaunay triangulation and Bowyer-Watson algorithm", J. Comput. Phys. 106 (1993): points
/// are placed where they make the next triangle of a front equilateral; smoothing evens out where fronts have met.
[[nodiscard]] Region meshRegion(const std::vector<Loop>& loops, const SizeFunction& size);

}  // namespace holdfast::generate
