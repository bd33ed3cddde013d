#pragma once
/// \file
/// Fewer triangles for a large mesh while it moves, over the same points.

#include <holdfast/widgets/mesh/shaded_surface.h>

namespace holdfast {

/// About how many triangles are drawn of what moves: as many as are drawn in a few milliseconds without a GPU.
inline constexpr Index kCoarseTriangles = 20'000;

/// Triangles over points of `surface`, which was cut from `model`, about `target` (larger than 0) of them; its own
/// where it has no more than one and a half times as many. Vertices near one another at rest that face the same way are
/// drawn as one of them, so that whatever moves the points moves these triangles as well. Without gaps where the model
/// has none. O(T log T).
[[nodiscard]] Polygons coarseTriangles(const Model& model, const ShadedSurface& surface, Index target);

}  // namespace holdfast
