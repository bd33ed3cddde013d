#pragma once
/// The motion of a handle said in another way, from where it is edited on: the picture stays as it is.

#include <span>
#include <string>
#include <vector>

#include <holdfast/constraints/handle_motion.h>
#include <holdfast/deform/model.h>

namespace holdfast {

/// Of the handles at these places of the list, enabled or not: vertices in the order of `VertexIds` that all differ,
/// ascending by id otherwise. Throws `InputError` where a handle or what is fixed does not fit the mesh; `source` names
/// the list. O(N) for each and for each fixed region.
[[nodiscard]] std::vector<HandleSetting> settingsOf(const Model& model, const ConstraintList& list,
                                                    std::span<const Index> handles, const std::string& source);
[[nodiscard]] HandleSetting settingOf(const Model& model, const ConstraintList& list, Index handle,
                                      const std::string& source);

/// "constraints[3]" of `source`.
[[nodiscard]] InputLocation placeInList(const std::string& source, Index constraint);

/// Each gives a handle that goes where `handle` goes and turns as it turns, up to rounding; `setting` is that of
/// `settingOf`. They throw `InputError` for a motion that the mesh does not allow (`placeHandle`), with the reason of
/// `validateHandle` for what the handle may not say, and for what is said below. O(vertices).

/// A handle with a `FrameMotion`: from the `principalAxes` of the handle at rest, in its centroid, to where its motion
/// takes them. Targets of vertices are lost: the frames say the rigid motion that fits them best. Throws where the
/// handle turns by whole turns, or nearly so: frames that coincide have no axis.
[[nodiscard]] HandleConstraint byFrames(const HandleConstraint& handle, const HandleSetting& setting);

/// By `VertexTargets`, where each vertex goes now, and no translation. Where these places do not say how the handle
/// turns (beyond half a turn, or on a line), each vertex gets a rotation of its own that does.
[[nodiscard]] HandleConstraint byTargets(const HandleConstraint& handle, const HandleSetting& setting);

/// A handle with a rotation for each vertex: that of the motion.
[[nodiscard]] HandleConstraint withRotations(const HandleConstraint& handle, const HandleSetting& setting);

}  // namespace holdfast
