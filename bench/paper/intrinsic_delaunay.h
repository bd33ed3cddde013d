#pragma once
/// \file
/// Intrinsic Delaunay triangulations: edges flipped within the surface, which keeps its shape (Bobenko and Springborn,
/// A discrete Laplace-Beltrami operator for simplicial surfaces, 2007).

#include <array>
#include <vector>

#include <holdfast/mesh/triangulation.h>
#include <holdfast/operators/cotangents.h>

namespace holdfast::paper {

/// Triangles by the lengths of their sides; side k goes from corner k to corner k + 1.
struct IntrinsicTriangles {
  std::vector<Triangle> triangles;
  std::vector<std::array<double, 3>> lengths;
};

/// Returns the intrinsic triangles of a mesh as it is.
[[nodiscard]] IntrinsicTriangles intrinsicTriangles(const Positions& positions, std::vector<Triangle> triangles);

/// Flips every edge between two triangles whose opposite angles are more than 180 degrees together, until there is
/// none. Then the sum of the two cotangents of every edge is not negative. Edges of one or of three triangles stay. The
/// number of flips is finite; about O(T) where few are needed.
[[nodiscard]] IntrinsicTriangles delaunay(IntrinsicTriangles mesh);

/// By lengths, with the area in a form that keeps its digits in thin triangles (Kahan).
[[nodiscard]] double area(const std::array<double, 3>& lengths);
[[nodiscard]] CornerCotangents cotangents(const std::array<double, 3>& lengths);

}  // namespace holdfast::paper
