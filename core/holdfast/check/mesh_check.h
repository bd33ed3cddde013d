#pragma once
/// What may be wrong with a mesh, found before anything is factorised. docs/errors.md lists the kinds.

#include <vector>

#include <holdfast/check/finding.h>
#include <holdfast/mesh/solver_mesh.h>
#include <holdfast/operators/operators.h>
#include <holdfast/rotation/edge_weights.h>

namespace holdfast {

/// A smallest angle below this makes a triangle a needle.
inline constexpr double kNeedleDegrees = 1;

/// Vertices of the surface with a coordinate that is NaN or infinite; nothing else may be asked of a mesh that has
/// such. O(N + corners).
[[nodiscard]] std::vector<Finding> findNonFinite(const Mesh& mesh);

/// Everything else, in a fixed order.
[[nodiscard]] std::vector<Finding> checkMesh(const Mesh& mesh, const Triangulation& triangulation,
                                             const SolverMesh& solverMesh);

/// Vertices where a guard of the weights acted, in those of the surface and in those of its rotations.
[[nodiscard]] std::vector<Finding> guardFindings(const Operators& operators, const SolverMesh& solverMesh);
[[nodiscard]] std::vector<Finding> guardFindings(const RotationWeights& weights, const SolverMesh& solverMesh);

/// Whether the mesh is the skin of something: every edge has two triangles, which run through it in opposite ways, and
/// every connected part encloses a positive volume at rest. True where there are no triangles. O(T log T).
[[nodiscard]] bool isSolid(const SolverMesh& mesh);

}  // namespace holdfast
