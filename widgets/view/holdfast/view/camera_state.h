#pragma once
/// \file
/// The camera of a renderer as sessions keep it, and back.

#include <holdfast/document/session_file.h>

class vtkCamera;

namespace holdfast {

[[nodiscard]] Camera cameraOf(vtkCamera& camera);

/// Places `camera` so that `cameraOf` gives `state` back. The angle of view and the clipping planes stay: set those
/// anew.
void place(vtkCamera& camera, const Camera& state);

}  // namespace holdfast
