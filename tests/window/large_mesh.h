#pragma once
/// \file
/// Meshes as large as scans, made in a moment.

#include <holdfast/mesh/mesh.h>

namespace holdfast::test {

/// A closed ellipsoid with smooth bumps, 120 x 100 x 180, of 6 n n + 2 vertices for n `divisions`: 173,402 for 170,
/// 437,402 for 270.
[[nodiscard]] Mesh bumpyEllipsoid(Index divisions);

}  // namespace holdfast::test
