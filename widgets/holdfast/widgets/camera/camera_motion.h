#pragma once
/// \file
/// How a hand on the mouse moves a camera: around a place, across the view, towards what is under the cursor.

#include <holdfast/widgets/camera/display_transform.h>

class vtkCamera;
class vtkRenderer;

namespace holdfast {

/// Turns eye and focal point about `pivot` (model units), which stays where it is on the screen: `degreesRight` about
/// the camera's up, `degreesUp` about its right, as if the hand turned the model. No pole where it stops or flips.
void orbit(vtkCamera& camera, const Vector3& pivot, double degreesRight, double degreesUp);

/// Shifts the camera across the view so that `anchor`, which was under `from`, comes to lie under `to`.
void pan(vtkRenderer& renderer, const Vector3& anchor, const DisplayPoint& from, const DisplayPoint& to);

/// Goes nearer by `factor` > 1, away by less than 1: the distance of `anchor` to the eye is divided by it, and `anchor`
/// stays where it is on the screen. With a parallel projection the picture grows about the anchor instead.
void zoom(vtkRenderer& renderer, const Vector3& anchor, double factor);

/// Where `display` is at the depth of `reference`: a place in model units.
[[nodiscard]] Vector3 atDepthOf(vtkRenderer& renderer, const Vector3& reference, const DisplayPoint& display);

/// Where a place is in the window; the third number is its depth in [0, 1] as far as it is between the clipping planes.
[[nodiscard]] Vector3 toDisplay(vtkRenderer& renderer, const Vector3& place);

}  // namespace holdfast
