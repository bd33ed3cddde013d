#pragma once
/// \file
/// Flat plates of triangles with one cause of instability each, and none of the others.

#include <vector>

#include <holdfast/mesh/mesh.h>

namespace holdfast::paper {

enum class Cause {
  SmallAngle,     ///< an edge that is short across a small angle: one large cotangent
  FlatAngle,      ///< an angle near 180 degrees: a large negative cotangent beside large ones
  SmallAreas,     ///< a few vertices among triangles that are small, and well shaped
  LargeAreas,     ///< a few vertices among triangles that are large, and well shaped
  CancellingArea  ///< (10), cotangent weights: a Voronoi area by its formula that is nearly zero, by obtuse angles
                  ///< alone
};

[[nodiscard]] const char* name(Cause cause);
[[nodiscard]] const std::vector<Cause>& allCauses();

/// About 2 x 2 in size, 1,000 to 6,000 vertices. `severity`, below 1, is the length or the area that is small, as a
/// share of the usual one. With `SmallAngle` and `FlatAngle` the vertices of `soundPlate` come first, where they are
/// there.
[[nodiscard]] Mesh badPlate(Cause cause, double severity);

/// Equilateral triangles: what all but the two causes of sizes are brought into.
[[nodiscard]] Mesh soundPlate();

}  // namespace holdfast::paper
