#pragma once
/// \file
/// Remeshing of a smooth closed surface by nearly equilateral triangles of a wanted size.

#include <functional>

#include "grouped_mesh.h"
#include "sdf.h"

namespace holdfast::generate {

/// Splits, collapses and flips edges and relaxes vertices along the surface `distance` = 0 until edges have about the
/// length that `size` wants at their middle (M. Botsch, L. Kobbelt, "A remeshing approach to multiresolution
/// modeling", SGP 2004). `mesh` is closed and lies near that surface; its groups are dropped.
[[nodiscard]] GroupedMesh remeshed(const GroupedMesh& mesh, const DistanceFunction& distance,
                                   const std::function<double(const Vector3&)>& size);

}  // namespace holdfast::generate
