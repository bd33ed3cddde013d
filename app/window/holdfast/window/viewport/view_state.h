#pragma once
/// Reads and applies what sessions keep of the view: the camera, the colours, and what is shown.

#include <holdfast/document/session_file.h>
#include <holdfast/widgets/camera/camera_state.h>
#include <holdfast/window/model/editor.h>

namespace holdfast {

class Viewport;

[[nodiscard]] ViewState viewStateOf(Viewport& viewport);

/// Applies a view to the viewport. Settings that `state` leaves out change nothing. Neither do unknown names, which a
/// newer version may have written.
void apply(const ViewState& state, Viewport& viewport);

/// Returns what the user has chosen last for meshes of this one's format. Before the first choice it returns y for
/// scans (`LoadedMesh::isScan`), and z for all others. Scans in STL files get z, too: these files are made for machines
/// whose z is up.
[[nodiscard]] UpAxis upAxisOf(const LoadedMesh& mesh);
void rememberUpAxis(const LoadedMesh& mesh, UpAxis axis);

}  // namespace holdfast
