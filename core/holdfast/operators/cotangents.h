#pragma once
/// Cotangents of the corners of triangles, plain and guarded, and the areas that go with vertices.

#include <array>
#include <vector>

#include <holdfast/mesh/triangulation.h>

namespace holdfast {

/// Cotangent of the angle at each corner of a triangle, in the triangle's order.
using CornerCotangents = std::array<double, 3>;

/// The cotangents as they are: dot over cross product. Infinite or NaN for triangles without area.
[[nodiscard]] CornerCotangents cornerCotangents(const Positions& positions, const Triangle& triangle);

/// Those of each triangle.
[[nodiscard]] std::vector<CornerCotangents> cornerCotangents(const Positions& positions,
                                                             const std::vector<Triangle>& triangles);

/// Largest magnitude of a guarded cotangent: that of 2.9 degrees. Caps of 10 to 50 behave alike on CAD and scan meshes;
/// without one, the normal equations of slivers lose all digits.
inline constexpr double kCotangentCap = 20;

/// Smallest guarded vertex area as a share of the mean: rows of smaller areas would outweigh all others.
inline constexpr double kAreaFloor = 1e-3;

/// The cotangents held within +-`kCotangentCap`. Where two corners coincide the angle is not defined: it counts as 60
/// degrees, which keeps the vertices tied to the mesh.
[[nodiscard]] CornerCotangents guarded(const CornerCotangents& cotangents);

/// Guards those of every triangle; returns the unknowns where that changed something, ascending.
[[nodiscard]] std::vector<Index> guardAll(std::vector<CornerCotangents>& cotangents,
                                          const std::vector<Triangle>& triangles);

/// Mixed Voronoi area of each unknown (Meyer, Desbrun, Schroeder, Barr, 2003): the Voronoi area in triangles without an
/// obtuse angle, a half or a quarter of the triangle's area otherwise. Never negative; the sum is the area of the mesh.
[[nodiscard]] Eigen::VectorXd mixedVoronoiAreas(const Positions& positions, const std::vector<Triangle>& triangles);

/// Area(i) of the cotangent weights (10): the Voronoi area of each unknown by its formula, obtuse angles or not, an
/// eighth of the sum of (cot alpha + cot beta) |p_i - p_j|^2. Negative or infinite on bad triangles.
[[nodiscard]] Eigen::VectorXd literalVoronoiAreas(const Positions& positions, const std::vector<Triangle>& triangles);

}  // namespace holdfast
