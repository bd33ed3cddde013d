#pragma once
/// Weights of soft constraints and of bending are stated for a length that no rotation of the model changes.

#include <holdfast/mesh/solver_mesh.h>
#include <holdfast/operators/weights.h>

namespace holdfast {

/// Returns the diameter of the smallest sphere around the mesh, as a share of the diagonal of its box. It is 0.57 to 1.
[[nodiscard]] double diameterInDiagonals(const SolverMesh& mesh);

/// Returns what rows of A = `weightedRows` are multiplied by to become rows for lengths in diameters. They are made for
/// lengths in diagonals.
[[nodiscard]] double rowsInDiameters(Weights weights, double diameterInDiagonals);

}  // namespace holdfast
