#pragma once
/// Meshes that are the skin of something: seen from outside only the fronts of their triangles are seen.

#include <holdfast/mesh/solver_mesh.h>

namespace holdfast {

/// Whether every edge has two triangles, which run through it in opposite ways, and every connected part encloses a
/// positive volume at rest. True where there are no triangles. O(T log T).
[[nodiscard]] bool isSolid(const SolverMesh& mesh);

}  // namespace holdfast
