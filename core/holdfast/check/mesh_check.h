#pragma once
/// These checks find what may be wrong with a mesh, before anything is factorised. docs/errors.md lists the kinds.

#include <vector>

#include <holdfast/check/finding.h>
#include <holdfast/mesh/solver_mesh.h>
#include <holdfast/operators/operators.h>
#include <holdfast/rotation/edge_weights.h>

namespace holdfast {

/// A smallest angle below this makes a triangle a needle.
inline constexpr double kNeedleDegrees = 1;

/// Finds the vertices of the surface with a coordinate that is NaN or infinite. Nothing else may be asked of a mesh
/// that has such. O(N + corners).
[[nodiscard]] std::vector<Finding> findNonFinite(const Mesh& mesh);

/// Finds everything else, in a fixed order.
[[nodiscard]] std::vector<Finding> checkMesh(const Mesh& mesh, const Triangulation& triangulation,
                                             const SolverMesh& solverMesh);

/// Finds the vertices where a guard of the weights acted. The first call is for the weights of the surface, the second
/// for those of its rotations.
[[nodiscard]] std::vector<Finding> guardFindings(const Operators& operators, const SolverMesh& solverMesh);
[[nodiscard]] std::vector<Finding> guardFindings(const RotationWeights& weights, const SolverMesh& solverMesh);

/// Tells whether the mesh is the skin of something. Then every edge has two triangles, which run through it in opposite
/// ways, and every connected part encloses a positive volume at rest. The result is true where there are no triangles.
/// O(T log T).
[[nodiscard]] bool isSolid(const SolverMesh& mesh);

}  // namespace holdfast
