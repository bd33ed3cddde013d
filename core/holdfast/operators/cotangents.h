#pragma once
/// The corners of triangles have cotangents, plain and guarded. Vertices have areas that go with them.

#include <array>
#include <vector>

#include <holdfast/mesh/triangulation.h>

namespace holdfast {

/// A triangle has the cotangent of the angle at each corner, in its own order.
using CornerCotangents = std::array<double, 3>;

/// Returns the cotangents as they are: dot over cross product. They are infinite or NaN for triangles without area.
[[nodiscard]] CornerCotangents cornerCotangents(const Positions& positions, const Triangle& triangle);

/// Returns the cotangents of each triangle.
[[nodiscard]] std::vector<CornerCotangents> cornerCotangents(const Positions& positions,
                                                             const std::vector<Triangle>& triangles);

/// No guarded cotangent has a larger magnitude than this, which is that of 2.9 degrees. Caps of 10 to 50 behave alike
/// on CAD and scan meshes. Without one, the normal equations of slivers lose all digits.
inline constexpr double kCotangentCap = 20;

/// No guarded vertex area is a smaller share of the mean than this. Rows of smaller areas would outweigh all others.
inline constexpr double kAreaFloor = 1e-3;

/// Returns the cotangents held within +-`kCotangentCap`. Where two corners coincide the angle is not defined. It counts
/// as 60 degrees, which keeps the vertices tied to the mesh.
[[nodiscard]] CornerCotangents guarded(const CornerCotangents& cotangents);

/// Guards the cotangents of every triangle. Returns the unknowns where that changed something, ascending.
[[nodiscard]] std::vector<Index> guardAll(std::vector<CornerCotangents>& cotangents,
                                          const std::vector<Triangle>& triangles);

/// Returns the mixed Voronoi area of each unknown (Meyer, Desbrun, Schroeder, Barr, 2003). In triangles without an
/// obtuse angle it is the Voronoi area. Otherwise it is a half or a quarter of the triangle's area. It is never
/// negative. The sum is the area of the mesh.
[[nodiscard]] Eigen::VectorXd mixedVoronoiAreas(const Positions& positions, const std::vector<Triangle>& triangles);

/// Returns Area(i) of the cotangent weights (10): the Voronoi area of each unknown by its formula, obtuse angles or
/// not. It is an eighth of the sum of (cot alpha + cot beta) |p_i - p_j|^2. It is negative or infinite on bad
/// triangles.
[[nodiscard]] Eigen::VectorXd literalVoronoiAreas(const Positions& positions, const std::vector<Triangle>& triangles);

}  // namespace holdfast
