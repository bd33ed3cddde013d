#pragma once
/// The places and vertices that constraints name, on the mesh of an editor at rest.

#include <optional>
#include <string>
#include <vector>

#include <holdfast/surface/surface_locator.h>
#include <holdfast/window/model/editor.h>

namespace holdfast {

/// The place that the solver starts from, bit for bit. Throws `InputError` if the open mesh has no such location.
[[nodiscard]] Vector3 requireRestPlace(const Editor& editor, const SurfaceLocation& location);

/// The same; nothing if there is no such location or no mesh is open.
[[nodiscard]] std::optional<Vector3> restPlace(const Editor& editor, const SurfaceLocation& location);

/// The point that goes to `place` to the last bit; a shift becomes a target only where no shift does so.
[[nodiscard]] PointConstraint goingTo(PointConstraint point, const Vector3& rest, const Vector3& place);

struct FoundVertices {
  std::vector<Index> vertices;  ///< ascending
  std::string reason;           ///< why the selection is invalid; empty if it is valid
};

/// A mesh is open. O(N) per node of the expression.
[[nodiscard]] FoundVertices findVertices(const Editor& editor, const Selection& selection);

}  // namespace holdfast
