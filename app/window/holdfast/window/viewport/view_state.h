#pragma once
/// What sessions keep of the view: the camera, the colours, and what is shown.

#include <holdfast/document/session_file.h>
#include <holdfast/widgets/camera/camera_state.h>
#include <holdfast/window/model/editor.h>

namespace holdfast {

class Viewport;

[[nodiscard]] ViewState viewStateOf(Viewport& viewport);

/// Settings that `state` leaves out, and unknown names (of a newer version), change nothing.
void apply(const ViewState& state, Viewport& viewport);

/// What the user has chosen last for meshes of this one's format. Before that: y for scans (`LoadedMesh::isScan`) but
/// in STL files, which are made for machines whose z is up; z for all others.
[[nodiscard]] UpAxis upAxisOf(const LoadedMesh& mesh);
void rememberUpAxis(const LoadedMesh& mesh, UpAxis axis);

}  // namespace holdfast
