#pragma once
/// Selections on one mesh: what they select, or why they make no sense there.

#include <optional>
#include <vector>

#include <holdfast/base/error.h>
#include <holdfast/constraints/selection.h>
#include <holdfast/mesh/edge_graph.h>
#include <holdfast/surface/surface_locator.h>

namespace holdfast {

/// Selects by curves on one mesh. What curves share (edges and their lengths) is made when the first one asks for it.
class CurveSelector {
 public:
  /// Both meshes stay alive as long as the selector.
  CurveSelector(const Mesh& mesh, const SolverMesh& solverMesh, SurfaceLocator locator)
      : mesh_(mesh), solverMesh_(solverMesh), locator_(std::move(locator))
  {
  }

  /// The vertices on the curve and on the side that it names, ascending. Each place goes to the nearest, at rest, of
  /// the vertices that it hangs on; then `closedCurve` and `regionOfCurve` do the work. Throws `InputError` at `where`,
  /// its element followed by the key at fault (".through[1].vertex"): places that are not on the mesh, that go to the
  /// same vertex, or that lie on different connected parts; a curve that leaves its part in one piece.
  [[nodiscard]] std::vector<Index> select(const InsideCurve& curve, const InputLocation& where);

 private:
  [[nodiscard]] Index nearestVertex(const SurfaceLocation& location, const InputLocation& where);
  [[nodiscard]] std::vector<Index> placesOf(const InsideCurve& curve, const InputLocation& where);
  [[nodiscard]] std::vector<Index> verticesOf(const std::vector<std::vector<Index>>& unknowns) const;

  const Mesh& mesh_;
  const SolverMesh& solverMesh_;
  SurfaceLocator locator_;
  std::optional<EdgeGraph> graph_;
};

/// Selects vertices of one mesh.
class Selector {
 public:
  /// Both meshes stay alive as long as the selector.
  Selector(const Mesh& mesh, const SolverMesh& solverMesh, SurfaceLocator locator);

  /// The vertices that `selection` names, ascending, each once. Throws `InputError` at `where`, its element followed by
  /// the key at fault (".any[1].vertices"): ids of vertices or parts that the mesh does not have; curves that
  /// `CurveSelector` refuses; a selection of no vertex at all. O(N) per node of the expression, and what curves cost.
  [[nodiscard]] std::vector<Index> select(const Selection& selection, const InputLocation& where);

 private:
  const Mesh& mesh_;
  std::vector<Index> componentOf_;
  Index componentCount_;
  CurveSelector curves_;
};

}  // namespace holdfast
