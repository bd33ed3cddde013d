#pragma once
/// A mesh made ready for deformation: what depends on neither constraints nor weights.

#include <memory>

#include <holdfast/check/mesh_check.h>
#include <holdfast/mesh/solver_mesh.h>
#include <holdfast/surface/surface_locator.h>

namespace holdfast {

struct Model {
  Mesh mesh;
  Triangulation triangulation;
  SolverMesh solverMesh;
  std::vector<Finding> findings;
  std::shared_ptr<SurfaceIndex> surface = std::make_shared<SurfaceIndex>();  ///< of the mesh at rest

  /// The one for all points of this model, from any thread. The model stays alive and in place as long as it.
  [[nodiscard]] SurfaceLocator locator() const { return {mesh, triangulation, surface}; }
};

/// Triangles at one vertex at most. The row of its Laplacian makes the normal equations dense over all its neighbours:
/// 8,000 take up to 2 GB and 13 s of a core, and both grow at least with the square.
inline constexpr Index kMostTrianglesAtAVertex = 8000;

/// Checks, triangulates and welds. Throws `InputError` for coordinates that are not finite, for a mesh without a
/// face or without a size that a double can say, and where vertices of more than 1,000 triangles come, by the sum of
/// squares, to more than one of `kMostTrianglesAtAVertex`; `source` names the mesh in messages. O(T log T).
[[nodiscard]] Model makeModel(Mesh mesh, const std::string& source);

/// Those of the triangulation, in its order and over unknowns; where vertices were welded, one may name an unknown
/// twice.
[[nodiscard]] std::vector<Triangle> trianglesOverUnknowns(const Model& model);

}  // namespace holdfast
