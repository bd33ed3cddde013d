#pragma once
/// The camera of a renderer: its first place, its state in sessions, and its motion by the mouse.

#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <holdfast/base/types.h>
#include <holdfast/document/session_file.h>
#include <holdfast/widgets/camera/display_transform.h>

namespace holdfast {

[[nodiscard]] Camera cameraOf(vtkCamera& camera);

/// Sets the view up to the unit vector along `up` that stays bit for bit when VTK normalizes it again.
void setViewUp(vtkCamera& camera, const Vector3& up);

/// `cameraOf` gives `state` back where `setViewUp` has set its view up. Set the view angle and clipping planes, too.
void place(vtkCamera& camera, const Camera& state);

/// Rotates eye and focal point about `pivot` (model units), which stays where it is on the screen: `degreesRight` about
/// the camera's up, `degreesUp` about its right. There is no pole at which it stops or flips.
void orbit(vtkCamera& camera, const Vector3& pivot, double degreesRight, double degreesUp);

/// Shifts the camera across the view so that `anchor`, which was under `from`, comes to lie under `to`.
void pan(vtkRenderer& renderer, const Vector3& anchor, const DisplayPoint& from, const DisplayPoint& to);

/// Divides the distance from `anchor`, which stays in its pixel, to the eye by `factor`, or magnifies a parallel view.
void zoom(vtkRenderer& renderer, const Vector3& anchor, double factor);

/// Where `display` is at the depth of `reference`: a place in model units.
[[nodiscard]] Vector3 atDepthOf(vtkRenderer& renderer, const Vector3& reference, const DisplayPoint& display);

/// Where a place is in the window; the third number is its depth in [0, 1] as far as it is between the clipping planes.
[[nodiscard]] Vector3 toDisplay(vtkRenderer& renderer, const Vector3& place);

/// A camera's frame: right-handed unit vectors.
struct ViewFrame {
  Vector3 right;
  Vector3 up;
  Vector3 back;  ///< from the mesh to the eye
};

/// The camera's present one.
[[nodiscard]] ViewFrame frameOf(vtkCamera& camera);

/// The axis of the model that is up. x is to the right of who looks from the front, at -y where z is up, at +z where y
/// is.
enum class UpAxis { Y, Z };

/// A direction of a model whose z is up, as it is in one whose `up` is.
[[nodiscard]] inline Vector3 upright(UpAxis up, const Vector3& direction)
{
  return up == UpAxis::Z ? direction : Vector3(direction.x(), direction.z(), -direction.y());
}

/// The eye is in front of the longer side (the front or the right one), rotated by a third of a right angle towards the
/// other of these two, and raised, higher above flat meshes.
[[nodiscard]] ViewFrame defaultFrame(const Positions& positions, UpAxis up = UpAxis::Z);

/// Shares of the picture's width.
struct FreeSides {
  double left = 0;
  double right = 0;
};

/// Places `camera` along `frame`, as near as `points` (one at least) fit a picture of width / height `aspect` between
/// two sides that stay free; in parallel projection as large as they fit. O(N).
void fit(vtkCamera& camera, const ViewFrame& frame, const Positions& points, double aspect, const FreeSides& free = {});

}  // namespace holdfast
