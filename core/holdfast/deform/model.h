#pragma once
/// A model is a mesh made ready for deformation. It depends on neither constraints nor weights.

#include <memory>
#include <string>
#include <vector>

#include <holdfast/check/finding.h>
#include <holdfast/io/mesh_document.h>
#include <holdfast/mesh/solver_mesh.h>

namespace holdfast {

class SurfaceIndex;
class SurfaceLocator;

/// A mesh that is checked, triangulated and welded.
struct Model {
  /// The mesh as it was given. Only the vertices of `SolverMesh::withoutPlace` get the position of a vertex of the
  /// surface.
  Mesh mesh;
  Triangulation triangulation;
  SolverMesh solverMesh;
  std::vector<Finding> findings;          ///< what is doubtful about the mesh
  std::shared_ptr<SurfaceIndex> surface;  ///< the search structure of the mesh at rest

  /// Returns the locator for all points of this model. Any thread may call this. The model must stay alive and in place
  /// as long as the locator.
  [[nodiscard]] SurfaceLocator locator() const;
};

/// No more triangles than this may meet at one vertex. The row of its Laplacian makes the normal equations dense over
/// all its neighbours. 8,000 neighbours take up to 2 GB and 13 s of a core, and both grow at least with the square.
inline constexpr Index kMostTrianglesAtAVertex = 8000;

/// Checks, triangulates and welds `mesh`. Messages call it `source`. Ends of open edges within `weldTolerance` of one
/// another, in model units, become one unknown. With the tolerance 0 only those in one place do. O(T log T).
///
/// Throws `InputError` in these cases:
/// - A corner of a face is no vertex.
/// - A coordinate of the surface is not finite.
/// - No face has three corners, or the mesh has no size that a double can hold.
/// - Too many triangles meet at vertices. The squares of their numbers, at vertices of more than 1,000, sum up to more
///   than the square of `kMostTrianglesAtAVertex`.
/// - `weldTolerance` is above `kLargestWeld` of the diagonal.
///
///     const Model model = makeModel({positions, Polygons(triangles)}, "part");
///     for (const Finding& finding : model.findings) std::cerr << finding.message << '\n';
[[nodiscard]] Model makeModel(Mesh mesh, const std::string& source = "mesh", double weldTolerance = 0);

/// The largest tolerance of welding, as a share of the diagonal. A larger one would join what was meant to be apart.
inline constexpr double kLargestWeld = 0.01;

/// Makes a model of the mesh of a file as `makeModel` does. Adds a finding for each remark about the file.
[[nodiscard]] Model makeModelOfFile(const MeshDocument& document, const std::string& source, double weldTolerance = 0);

/// Returns the triangles of the triangulation over unknowns, in its order. Where vertices were welded, a triangle may
/// name an unknown twice.
[[nodiscard]] std::vector<Triangle> trianglesOverUnknowns(const Model& model);

}  // namespace holdfast
