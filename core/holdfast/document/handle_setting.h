#pragma once
/// \file
/// What the motion of a handle depends on besides the handle, found in the list that it stands in.

#include <optional>
#include <string>
#include <vector>

#include <holdfast/constraints/handle_motion.h>
#include <holdfast/constraints/selector.h>
#include <holdfast/deform/model.h>

namespace holdfast {

/// What `placeHandle` takes with the handle.
struct HandleSetting {
  Positions rest;  ///< its vertices: in the order of `VertexIds` that all differ, ascending by id otherwise
  HandleSurroundings surroundings;
  InputLocation where;
};

/// That of the handle at `index` of the list, enabled or not. Throws `InputError` where the handle or what is fixed
/// does not fit the mesh; `source` names the list. O(N) for it and for each fixed region.
[[nodiscard]] HandleSetting settingOf(const Model& model, const ConstraintList& list, Index index,
                                      const std::string& source);

/// "constraints[3]" of `source`.
[[nodiscard]] InputLocation placeInList(const std::string& source, Index constraint);

[[nodiscard]] Positions rowsOf(const Positions& positions, const std::vector<Index>& vertices);

/// The centroid of all that the enabled fixed constraints hold, at rest; none where nothing is fixed. Throws as
/// `settingOf`.
[[nodiscard]] std::optional<Vector3> centerOfFixed(const Model& model, const ConstraintList& list, Selector& selector,
                                                   const std::string& source);

}  // namespace holdfast
