#pragma once
/// These functions state the motion of a handle in another way, in which it is edited on. The picture stays as it is.
/// Others give the axes of what a user moves, instead of those of the world.

#include <span>
#include <string>
#include <vector>

#include <holdfast/constraints/handle_motion.h>
#include <holdfast/deform/model.h>
#include <holdfast/surface/surface_point.h>

namespace holdfast {

/// Returns the settings of the handles at these places of the list. Vertices are in the order of `VertexIds` if those
/// all differ, and ascend by id otherwise. Throws `InputError` where a handle or what is fixed does not fit the mesh.
/// `source` names the list.
[[nodiscard]] std::vector<HandleSetting> settingsOf(const Model& model, const ConstraintList& list,
                                                    std::span<const Index> handles, const std::string& source);

/// Returns the place "constraints[3]" of `source` where `constraint` is 3.
[[nodiscard]] InputLocation placeInList(const std::string& source, Index constraint);

/// The next three return a handle that goes where `handle` goes and turns as it turns, up to rounding. They throw
/// `InputError` as `placeHandle` does. They also throw it with the reason of `validateHandle` for what a handle may not
/// say.

/// Returns a handle with a `FrameMotion`. It goes from the `principalAxes` of the handle at rest, in its centroid, to
/// where its motion takes them. Targets of vertices are lost. Throws where the handle turns by whole turns, or nearly
/// so.
[[nodiscard]] HandleConstraint byFrames(const HandleConstraint& handle, const HandleSetting& setting);

/// Returns a handle with `VertexTargets`, where each vertex goes now, and no translation. These places may not say how
/// the handle turns (beyond half a turn, or on a line). Then each vertex gets a rotation of its own that does.
[[nodiscard]] HandleConstraint byTargets(const HandleConstraint& handle, const HandleSetting& setting);

/// Returns a handle with a rotation for each vertex, which is that of the motion.
[[nodiscard]] HandleConstraint withRotations(const HandleConstraint& handle, const HandleSetting& setting);

/// Returns right-handed orthonormal columns. The z axis is along `direction`. The x axis is along the axis of the world
/// that is most nearly across it, as far as that is across. Returns the identity where the direction is zero.
[[nodiscard]] Eigen::Matrix3d axesAbout(const Vector3& direction);

/// Returns axes with z across the surface, and x and y along it. z is the area-weighted mean of the normals of faces.
/// They are the faces that the point lies in, on an edge of, or on a vertex of. Returns the identity where these have
/// no area. `positions` has one row for each vertex of the file. O(faces).
[[nodiscard]] Eigen::Matrix3d surfaceAxes(const Model& model, const SurfacePoint& point, const Positions& positions);

/// Returns axes with z along the principal axis of `places` whose variance differs most from the other two. That is the
/// axis of a shaft, or the normal of a plate. Returns the identity where the three are alike within a twentieth of the
/// largest. O(places).
[[nodiscard]] Eigen::Matrix3d principalAxes(const Positions& places);

}  // namespace holdfast
