#pragma once
/// \file
/// A closed surface of any size for measurements: as irregular as a scan, the same on every run.

#include <holdfast/mesh/mesh.h>

namespace holdfast::bench {

/// An ellipsoid with smooth bumps and about as many vertices: a cube's grid pushed outwards, its vertices shaken within
/// the surface, its squares split along either diagonal, its triangles longer one way than the other. About two units
/// long.
[[nodiscard]] Mesh bumpyMesh(Index vertices);

}  // namespace holdfast::bench
