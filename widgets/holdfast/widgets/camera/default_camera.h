#pragma once
/// \file
/// From where a mesh is looked at when nobody has chosen: a three-quarter view that fits the picture.

#include <holdfast/base/types.h>

class vtkCamera;

namespace holdfast {

/// A camera's frame: right-handed unit vectors.
struct ViewFrame {
  Vector3 right;
  Vector3 up;
  Vector3 back;  ///< from the mesh to the eye
};

/// z is up and -y the front. The eye is in front of the longer of the sides that stand (at -y, or at +x for what is
/// longer along y), turned by a third of a right angle towards the other of these two, and raised; higher above what
/// lies flat.
[[nodiscard]] ViewFrame defaultFrame(const Positions& positions);

/// Places `camera` along `frame`, as near as all `points` (at least one) are in a picture of `aspect` = width / height
/// with a margin around them. Exact for the perspective, not for a bounding sphere. O(N).
void fit(vtkCamera& camera, const ViewFrame& frame, const Positions& points, double aspect);

}  // namespace holdfast
