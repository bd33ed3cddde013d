#pragma once
/// \file
/// Selections on one mesh: what they select, or why they make no sense there.

#include <vector>

#include <holdfast/base/error.h>
#include <holdfast/constraints/curve_selector.h>
#include <holdfast/constraints/selection.h>

namespace holdfast {

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
