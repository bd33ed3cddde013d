#pragma once
/// \file
/// The surface of an implicit shape as a first, rough triangle mesh.

#include <Eigen/Geometry>

#include "grouped_mesh.h"
#include "sdf.h"

namespace holdfast::generate {

/// Samples `distance` on a grid of width `step` over `box`, which must hold the whole shape, and cuts the tetrahedra
/// of the grid ("marching tetrahedra"). Closed, manifold and outward, whatever the shape; the triangles are uneven,
/// and vertices keep a distance from grid nodes, so that none is tiny, rather than lie quite on the surface.
[[nodiscard]] GroupedMesh contour(const DistanceFunction& distance, const Eigen::AlignedBox3d& box, double step);

}  // namespace holdfast::generate
