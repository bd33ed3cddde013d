#pragma once
/// The length that weights of soft constraints and of bending are stated for: no rotation of the model changes it.

#include <holdfast/mesh/solver_mesh.h>
#include <holdfast/operators/weights.h>

namespace holdfast {

/// The diameter of the smallest sphere around the mesh, as a share of the diagonal of its box. 0.57 to 1.
[[nodiscard]] double diameterInDiagonals(const SolverMesh& mesh);

/// What rows of A = `weightedRows`, made for lengths in diagonals, are multiplied by for lengths in diameters.
[[nodiscard]] double rowsInDiameters(Weights weights, double diameterInDiagonals);

}  // namespace holdfast
