#pragma once
/// \file
/// A mesh made ready for deformation: what depends on neither constraints nor weights.

#include <holdfast/check/mesh_check.h>
#include <holdfast/mesh/solver_mesh.h>

namespace holdfast {

struct Model {
  Mesh mesh;
  Triangulation triangulation;
  SolverMesh solverMesh;
  std::vector<Finding> findings;
};

/// Checks, triangulates and welds. Throws `InputError` for coordinates that are not finite and for a mesh without a
/// face or without a size that a double can say; `source` names the mesh in messages. O(T log T).
[[nodiscard]] Model makeModel(Mesh mesh, const std::string& source);

/// Those of the triangulation, in its order and over unknowns; where vertices were welded, one may name an unknown
/// twice.
[[nodiscard]] std::vector<Triangle> trianglesOverUnknowns(const Model& model);

}  // namespace holdfast
