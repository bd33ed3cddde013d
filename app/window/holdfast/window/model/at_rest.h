#pragma once
/// Finds the places and vertices that constraints name, on the mesh of an editor at rest.

#include <optional>
#include <string>
#include <vector>

#include <holdfast/surface/surface_locator.h>
#include <holdfast/window/model/editor.h>

namespace holdfast {

/// Returns the place that the solver starts from, bit for bit. Throws `InputError` if the open mesh has no such
/// location.
[[nodiscard]] Vector3 requireRestPlace(const Editor& editor, const SurfaceLocation& location);

/// Returns the place that `requireRestPlace` returns. It returns nothing if there is no such location or no mesh is
/// open.
[[nodiscard]] std::optional<Vector3> restPlace(const Editor& editor, const SurfaceLocation& location);

/// Returns `constraint` with another target, as `setTarget` sets it. It returns nothing for a constraint that has no
/// target, and for a place that the open mesh does not have.
[[nodiscard]] std::optional<Constraint> withTarget(Constraint constraint, const Vector3& target, const Editor& editor);

struct FoundVertices {
  std::vector<Index> vertices;  ///< ascending
  std::string reason;           ///< why the selection is invalid; empty if it is valid
};

/// Finds the vertices that a selection names. A mesh is open. O(N) per node of the expression.
[[nodiscard]] FoundVertices findVertices(const Editor& editor, const Selection& selection);

}  // namespace holdfast
