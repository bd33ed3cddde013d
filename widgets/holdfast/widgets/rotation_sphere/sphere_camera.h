#pragma once
/// The camera before a unit sphere about the origin, in parallel projection.

#include <vector>

#include <vtkCamera.h>

#include <holdfast/base/types.h>

namespace holdfast {

/// The direction in which the camera looks, of length 1.
[[nodiscard]] inline Vector3 sightOf(vtkCamera& camera)
{
  return Vector3(camera.GetDirectionOfProjection());
}

/// Shows all `places`, at least one, from a little beside their middle; the whole sphere where they reach around it.
void lookAtPlaces(vtkCamera& camera, const std::vector<Vector3>& places);

/// Shows what is in the picture `factor` times as large, within bounds.
void zoomSphere(vtkCamera& camera, double factor);

}  // namespace holdfast
