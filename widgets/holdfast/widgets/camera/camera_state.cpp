#include "holdfast/widgets/camera/camera_state.h"

#include <cmath>

#include <vtkCamera.h>

namespace holdfast {
namespace {

// Four are the most that any of ten million random vectors took.
constexpr int kMostSteps = 10;

}  // namespace

Camera cameraOf(vtkCamera& camera)
{
  return {Vector3(camera.GetPosition()[0], camera.GetPosition()[1], camera.GetPosition()[2]),
          Vector3(camera.GetFocalPoint()[0], camera.GetFocalPoint()[1], camera.GetFocalPoint()[2]),
          Vector3(camera.GetViewUp()[0], camera.GetViewUp()[1], camera.GetViewUp()[2]), camera.GetParallelScale(),
          camera.GetParallelProjection() != 0};
}

void setViewUp(vtkCamera& camera, const Vector3& up)
{
  camera.SetViewUp(up.data());
  Vector3 unit(camera.GetViewUp());
  Index largest = 0;
  unit.cwiseAbs().maxCoeff(&largest);
  // Where VTK does not find the length 1, one unit in the last place of the largest component brings it nearer.
  for (int step = 0; step < kMostSteps; ++step) {
    camera.SetViewUp(unit.data());
    const Vector3 kept(camera.GetViewUp());
    if (kept == unit) return;
    unit[largest] = std::nextafter(unit[largest], kept[largest]);
  }
}

void place(vtkCamera& camera, const Camera& state)
{
  camera.SetPosition(state.position.x(), state.position.y(), state.position.z());
  camera.SetFocalPoint(state.focalPoint.x(), state.focalPoint.y(), state.focalPoint.z());
  setViewUp(camera, state.viewUp);
  camera.SetParallelScale(state.parallelScale);
  camera.SetParallelProjection(state.isParallel ? 1 : 0);
}

}  // namespace holdfast
