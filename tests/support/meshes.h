#pragma once
/// \file
/// Small meshes that tests make themselves.

#include <holdfast/mesh/mesh.h>

namespace holdfast::test {

/// The plane z = 0 over [0, columns] x [0, rows], two triangles a square, vertex (i, j) has the id j (columns + 1) + i.
[[nodiscard]] Mesh grid(Index columns, Index rows);

/// A closed box of side lengths `size`, each side a grid of `divisions` squares a direction, vertices shared.
[[nodiscard]] Mesh box(const Vector3& size, Index divisions);

/// A closed unit sphere: an icosahedron split `levels` times.
[[nodiscard]] Mesh icosphere(int levels);

/// A regular tetrahedron.
[[nodiscard]] Mesh tetrahedron();

/// Both meshes in one, `b` after `a`.
[[nodiscard]] Mesh merged(const Mesh& a, const Mesh& b);

}  // namespace holdfast::test
