#include "holdfast/view/camera_state.h"

#include <vtkCamera.h>

namespace holdfast {

Camera cameraOf(vtkCamera& camera)
{
  return {Vector3(camera.GetPosition()[0], camera.GetPosition()[1], camera.GetPosition()[2]),
          Vector3(camera.GetFocalPoint()[0], camera.GetFocalPoint()[1], camera.GetFocalPoint()[2]),
          Vector3(camera.GetViewUp()[0], camera.GetViewUp()[1], camera.GetViewUp()[2]), camera.GetParallelScale(),
          camera.GetParallelProjection() != 0};
}

void place(vtkCamera& camera, const Camera& state)
{
  camera.SetPosition(state.position.x(), state.position.y(), state.position.z());
  camera.SetFocalPoint(state.focalPoint.x(), state.focalPoint.y(), state.focalPoint.z());
  camera.SetViewUp(state.viewUp.x(), state.viewUp.y(), state.viewUp.z());
  camera.SetParallelScale(state.parallelScale);
  camera.SetParallelProjection(state.isParallel ? 1 : 0);
}

}  // namespace holdfast
