#pragma once
/// A selector tells what selections select on one mesh, or why they make no sense there.

#include <holdfast/constraints/selection.h>
#include <holdfast/surface/edge_graph.h>
#include <holdfast/surface/surface_locator.h>

namespace holdfast {

/// Selects vertices of one mesh. Both meshes must stay alive as long as the selector.
class Selector {
 public:
  Selector(const Mesh& mesh, const SolverMesh& solverMesh, SurfaceLocator locator)
      : mesh_(mesh), solverMesh_(solverMesh), locator_(std::move(locator))
  {
  }

  /// Returns the vertices that `selection` names, ascending, each once. Throws `InputError` at `where` and the key at
  /// fault (".any[1].vertices"). It refuses ids that the mesh does not have, and a selection of no vertex at all. It
  /// refuses curves through places that are not on the mesh, that do not differ, or that lie on different parts. It
  /// refuses curves that divide nothing. O(N) per node, and what curves cost.
  [[nodiscard]] std::vector<Index> select(const Selection& selection, const InputLocation& where);

 private:
  [[nodiscard]] std::vector<Index> within(const InsideCurve& curve, const InputLocation& where);
  [[nodiscard]] std::vector<Index> around(const std::vector<Index>& vertices, Index rings);
  [[nodiscard]] const EdgeGraph& graph();
  [[nodiscard]] std::vector<Index> verticesWhere(const std::vector<bool>& isSelected) const;
  [[nodiscard]] Index nearestVertex(const SurfaceLocation& location, const InputLocation& where);
  [[nodiscard]] std::vector<Index> placesOf(const InsideCurve& curve, const InputLocation& where);

  const Mesh& mesh_;
  const SolverMesh& solverMesh_;
  std::vector<int> componentOf_;  // of vertices; made for the first selection
  SurfaceLocator locator_;
  std::optional<EdgeGraph> graph_;  // made for the first curve or ring
};

}  // namespace holdfast
