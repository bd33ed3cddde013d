#pragma once
/// \file
/// The camera of a renderer as sessions keep it, and back.

#include <holdfast/document/session_file.h>

class vtkCamera;

namespace holdfast {

[[nodiscard]] Camera cameraOf(vtkCamera& camera);

/// Sets the view up to the unit vector along `up` that VTK keeps: given it again, it stays bit for bit. VTK normalizes
/// every view up that it is given, and rounding may change the last bit of one that is normalized already.
void setViewUp(vtkCamera& camera, const Vector3& up);

/// Places `camera` so that `cameraOf` gives `state` back, if the view up is one that `setViewUp` has set. The angle of
/// view and the clipping planes stay: set those anew.
void place(vtkCamera& camera, const Camera& state);

}  // namespace holdfast
