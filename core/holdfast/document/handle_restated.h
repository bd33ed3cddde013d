#pragma once
/// The motion of a handle said in another way, from where it is edited on: the picture stays as it is. And the axes of
/// what a user moves, instead of those of the world.

#include <span>
#include <string>
#include <vector>

#include <holdfast/constraints/handle_motion.h>
#include <holdfast/deform/model.h>
#include <holdfast/surface/surface_point.h>

namespace holdfast {

/// Of the handles at these places of the list: vertices in the order of `VertexIds` that all differ, ascending by id
/// otherwise. Throws `InputError` where a handle or what is fixed does not fit the mesh; `source` names the list.
[[nodiscard]] std::vector<HandleSetting> settingsOf(const Model& model, const ConstraintList& list,
                                                    std::span<const Index> handles, const std::string& source);

/// "constraints[3]" of `source`.
[[nodiscard]] InputLocation placeInList(const std::string& source, Index constraint);

/// These give a handle that goes where `handle` goes and turns as it turns, up to rounding. They throw `InputError` as
/// `placeHandle` does, and with the reason of `validateHandle` for what a handle may not say.

/// A handle with a `FrameMotion`: from the `principalAxes` of the handle at rest, in its centroid, to where its motion
/// takes them; targets of vertices are lost. Throws where the handle turns by whole turns, or nearly so.
[[nodiscard]] HandleConstraint byFrames(const HandleConstraint& handle, const HandleSetting& setting);

/// By `VertexTargets`, where each vertex goes now, and no translation. Where these places do not say how the handle
/// turns (beyond half a turn, or on a line), each vertex gets a rotation of its own that does.
[[nodiscard]] HandleConstraint byTargets(const HandleConstraint& handle, const HandleSetting& setting);

/// A handle with a rotation for each vertex: that of the motion.
[[nodiscard]] HandleConstraint withRotations(const HandleConstraint& handle, const HandleSetting& setting);

/// Right-handed orthonormal columns: z along `direction`, x along the axis of the world that is most nearly across it,
/// as far as it is. The identity where the direction is zero.
[[nodiscard]] Eigen::Matrix3d axesAbout(const Vector3& direction);

/// z across the surface, x and y along it: the area-weighted mean of the faces that the point lies in, on an edge or a
/// vertex of. The identity where these have no area. `positions`: one row for each vertex of the file. O(faces).
[[nodiscard]] Eigen::Matrix3d surfaceAxes(const Model& model, const SurfacePoint& point, const Positions& positions);

/// z along the principal axis of `places` whose variance differs most from the other two: the axis of a shaft, the
/// normal of a plate. The identity where the three are alike within a twentieth of the largest. O(places).
[[nodiscard]] Eigen::Matrix3d principalAxes(const Positions& places);

}  // namespace holdfast
