#pragma once
/// A mesh made ready for deformation: what depends on neither constraints nor weights.

#include <memory>
#include <string>
#include <vector>

#include <holdfast/check/finding.h>
#include <holdfast/io/mesh_document.h>
#include <holdfast/mesh/solver_mesh.h>

namespace holdfast {

class SurfaceIndex;
class SurfaceLocator;

struct Model {
  /// As it was given, but for the positions of `SolverMesh::withoutPlace`, which are those of a vertex of the surface.
  Mesh mesh;
  Triangulation triangulation;
  SolverMesh solverMesh;
  std::vector<Finding> findings;          ///< what is doubtful about the mesh
  std::shared_ptr<SurfaceIndex> surface;  ///< of the mesh at rest

  /// The one for all points of this model, from any thread. The model stays alive and in place as long as it.
  [[nodiscard]] SurfaceLocator locator() const;
};

/// Triangles at one vertex at most. The row of its Laplacian makes the normal equations dense over all its neighbours:
/// 8,000 take up to 2 GB and 13 s of a core, and both grow at least with the square.
inline constexpr Index kMostTrianglesAtAVertex = 8000;

/// Checks, triangulates and welds. `source` names the mesh in messages. Throws `InputError` for a corner that is no
/// vertex, for coordinates of the surface that are not finite, for a mesh without a face of three corners or without a
/// size that a double can hold, and for vertices of more than 1,000 triangles that come, by the sum of squares, to more
/// than one of `kMostTrianglesAtAVertex`. Ends of open edges within `weldTolerance` of one another are one unknown; 0:
/// those in one place are. Throws `InputError` for one above `kLargestWeld` of the diagonal. O(T log T).
[[nodiscard]] Model makeModel(Mesh mesh, const std::string& source = "mesh", double weldTolerance = 0);

/// The largest tolerance of welding, as a share of the diagonal: more would join what was meant to be apart.
inline constexpr double kLargestWeld = 0.01;

/// The same of a file, with findings about what is odd in it.
[[nodiscard]] Model makeModelOfFile(const MeshDocument& document, const std::string& source, double weldTolerance = 0);

/// Those of the triangulation, in its order and over unknowns; where vertices were welded, one may name an unknown
/// twice.
[[nodiscard]] std::vector<Triangle> trianglesOverUnknowns(const Model& model);

}  // namespace holdfast
