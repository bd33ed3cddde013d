#pragma once
/// The camera of a renderer: its first place, its state in sessions, and its motion by the mouse.

#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <holdfast/document/session_file.h>
#include <holdfast/numbers/types.h>
#include <holdfast/widgets/camera/display_transform.h>

namespace holdfast {

/// Returns the state of a camera as sessions keep it.
[[nodiscard]] Camera cameraOf(vtkCamera& camera);

/// Sets the view up to the unit vector along `up` that stays bit for bit when VTK normalises it again.
void setViewUp(vtkCamera& camera, const Vector3& up);

/// Gives the camera a state. `cameraOf` gives `state` back where `setViewUp` has set its view up. Set the view angle
/// and clipping planes, too.
void place(vtkCamera& camera, const Camera& state);

/// Rotates eye and focal point about `pivot` (model units), which stays where it is on the screen. They rotate by
/// `degreesRight` about the camera's up, and by `degreesUp` about its right. There is no pole at which the motion stops
/// or flips.
void orbit(vtkCamera& camera, const Vector3& pivot, double degreesRight, double degreesUp);

/// Shifts the camera across the view so that `anchor`, which was under `from`, comes to lie under `to`.
void pan(vtkRenderer& renderer, const Vector3& anchor, const DisplayPoint& from, const DisplayPoint& to);

/// Divides the distance from `anchor` to the eye by `factor`, or magnifies a parallel view by it. `anchor` stays in its
/// pixel.
void zoom(vtkRenderer& renderer, const Vector3& anchor, double factor);

/// Returns the place in model units that is at `display`, at the depth of `reference`.
[[nodiscard]] Vector3 atDepthOf(vtkRenderer& renderer, const Vector3& reference, const DisplayPoint& display);

/// Returns where a place is in the window. The third number is its depth, which is in [0, 1] between the clipping
/// planes.
[[nodiscard]] Vector3 toDisplay(vtkRenderer& renderer, const Vector3& place);

/// A camera's frame: right-handed unit vectors.
struct ViewFrame {
  Vector3 right;
  Vector3 up;
  Vector3 back;  ///< from the mesh to the eye
};

/// Returns the camera's present frame.
[[nodiscard]] ViewFrame frameOf(vtkCamera& camera);

/// The axis of the model that is up. x is to the right of a viewer who looks from the front. The front is at -y where z
/// is up, and at +z where y is up.
enum class UpAxis { Y, Z };

/// Turns a direction of a model whose z is up into that of a model whose `up` is up.
[[nodiscard]] inline Vector3 upright(UpAxis up, const Vector3& direction)
{
  return up == UpAxis::Z ? direction : Vector3(direction.x(), direction.z(), -direction.y());
}

/// Returns the frame of a first view. The eye is in front of the longer side, which is the front or the right one. It
/// is rotated by about a third of a right angle towards the other of these two. It is also raised, and higher above
/// flat meshes.
[[nodiscard]] ViewFrame defaultFrame(const Positions& positions, UpAxis up = UpAxis::Z);

/// How much of the picture stays free at each side, as shares of its width.
struct FreeSides {
  double left = 0;
  double right = 0;
};

/// Places `camera` along `frame` so that `points` fit a picture of width / height `aspect`. There is at least one
/// point. The two sides of the picture stay free. The camera goes as near as the points fit; in parallel projection it
/// shows them as large as they fit. O(N).
void fit(vtkCamera& camera, const ViewFrame& frame, const Positions& points, double aspect, const FreeSides& free = {});

}  // namespace holdfast
