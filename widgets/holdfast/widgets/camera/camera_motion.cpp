#include "holdfast/widgets/camera/camera_motion.h"

#include <Eigen/Geometry>
#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <holdfast/geometry/degree.h>
#include <holdfast/widgets/camera/camera_state.h>

namespace holdfast {
namespace {

Vector3 vectorOf(const double* values)
{
  return {values[0], values[1], values[2]};
}

}  // namespace

void orbit(vtkCamera& camera, const Vector3& pivot, double degreesRight, double degreesUp)
{
  const Vector3 up = vectorOf(camera.GetViewUp()).normalized();
  const Vector3 forward = vectorOf(camera.GetDirectionOfProjection()).normalized();
  const Vector3 right = forward.cross(up).normalized();
  // The camera turns against the model.
  const Eigen::Matrix3d turn =
      (Eigen::AngleAxisd(-degreesRight * kDegree, up) * Eigen::AngleAxisd(degreesUp * kDegree, right))
          .toRotationMatrix();
  const Vector3 eye = pivot + turn * (vectorOf(camera.GetPosition()) - pivot);
  const Vector3 focus = pivot + turn * (vectorOf(camera.GetFocalPoint()) - pivot);
  const Vector3 newUp = turn * right.cross(forward);
  camera.SetPosition(eye.data());
  camera.SetFocalPoint(focus.data());
  setViewUp(camera, newUp);
}

void pan(vtkRenderer& renderer, const Vector3& anchor, const DisplayPoint& from, const DisplayPoint& to)
{
  vtkCamera& camera = *renderer.GetActiveCamera();
  const Vector3 shift = atDepthOf(renderer, anchor, from) - atDepthOf(renderer, anchor, to);
  const Vector3 eye = vectorOf(camera.GetPosition()) + shift;
  const Vector3 focus = vectorOf(camera.GetFocalPoint()) + shift;
  camera.SetPosition(eye.data());
  camera.SetFocalPoint(focus.data());
}

void zoom(vtkRenderer& renderer, const Vector3& anchor, double factor)
{
  vtkCamera& camera = *renderer.GetActiveCamera();
  const Vector3 eye = vectorOf(camera.GetPosition());
  const Vector3 focus = vectorOf(camera.GetFocalPoint());
  Vector3 shift = (1 - 1 / factor) * (anchor - eye);
  if (camera.GetParallelProjection()) {
    camera.SetParallelScale(camera.GetParallelScale() / factor);
    const Vector3 forward = vectorOf(camera.GetDirectionOfProjection()).normalized();
    shift -= shift.dot(forward) * forward;
  }
  const Vector3 newEye = eye + shift;
  const Vector3 newFocus = anchor + (focus - anchor) / factor;
  const Vector3 shiftedFocus = focus + shift;
  camera.SetPosition(newEye.data());
  camera.SetFocalPoint(camera.GetParallelProjection() ? shiftedFocus.data() : newFocus.data());
}

Vector3 toDisplay(vtkRenderer& renderer, const Vector3& place)
{
  renderer.SetWorldPoint(place.x(), place.y(), place.z(), 1);
  renderer.WorldToDisplay();
  return vectorOf(renderer.GetDisplayPoint());
}

Vector3 atDepthOf(vtkRenderer& renderer, const Vector3& reference, const DisplayPoint& display)
{
  renderer.SetDisplayPoint(display.x(), display.y(), toDisplay(renderer, reference).z());
  renderer.DisplayToWorld();
  const double* world = renderer.GetWorldPoint();
  return vectorOf(world) / world[3];
}

}  // namespace holdfast
