#include "holdfast/widgets/camera/camera_state.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include <holdfast/geometry/bounding_box.h>
#include <holdfast/geometry/rotation_log.h>

namespace holdfast {
namespace {

// Four are the most that any of ten million random vectors took.
constexpr int kMostSteps = 10;

constexpr double kTurnDegrees = 32;
constexpr double kRiseDegrees = 24;

// A mesh that is flatter than this share of its length is looked at from higher up.
constexpr double kFlat = 0.3;
constexpr double kRiseOverFlatDegrees = 36;

// A long lens: parallel edges stay nearly parallel.
constexpr double kViewAngleDegrees = 18;

// A share of the picture's height and width.
constexpr double kMargin = 0.06;

}  // namespace

Camera cameraOf(vtkCamera& camera)
{
  return {Vector3(camera.GetPosition()), Vector3(camera.GetFocalPoint()), Vector3(camera.GetViewUp()),
          camera.GetParallelScale(), camera.GetParallelProjection() != 0};
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
  camera.SetPosition(state.position.data());
  camera.SetFocalPoint(state.focalPoint.data());
  setViewUp(camera, state.viewUp);
  camera.SetParallelScale(state.parallelScale);
  camera.SetParallelProjection(state.isParallel ? 1 : 0);
}

void orbit(vtkCamera& camera, const Vector3& pivot, double degreesRight, double degreesUp)
{
  const Vector3 up = Vector3(camera.GetViewUp()).normalized();
  const Vector3 forward = Vector3(camera.GetDirectionOfProjection()).normalized();
  const Vector3 right = forward.cross(up).normalized();
  // The camera rotates against the model.
  const Eigen::Matrix3d turn =
      (Eigen::AngleAxisd(-degreesRight * kDegree, up) * Eigen::AngleAxisd(degreesUp * kDegree, right))
          .toRotationMatrix();
  const Vector3 eye = pivot + turn * (Vector3(camera.GetPosition()) - pivot);
  const Vector3 focus = pivot + turn * (Vector3(camera.GetFocalPoint()) - pivot);
  const Vector3 newUp = turn * right.cross(forward);
  camera.SetPosition(eye.data());
  camera.SetFocalPoint(focus.data());
  setViewUp(camera, newUp);
}

void pan(vtkRenderer& renderer, const Vector3& anchor, const DisplayPoint& from, const DisplayPoint& to)
{
  vtkCamera& camera = *renderer.GetActiveCamera();
  const Vector3 shift = atDepthOf(renderer, anchor, from) - atDepthOf(renderer, anchor, to);
  const Vector3 eye = Vector3(camera.GetPosition()) + shift;
  const Vector3 focus = Vector3(camera.GetFocalPoint()) + shift;
  camera.SetPosition(eye.data());
  camera.SetFocalPoint(focus.data());
}

void zoom(vtkRenderer& renderer, const Vector3& anchor, double factor)
{
  vtkCamera& camera = *renderer.GetActiveCamera();
  const Vector3 eye = Vector3(camera.GetPosition());
  const Vector3 focus = Vector3(camera.GetFocalPoint());
  Vector3 shift = (1 - 1 / factor) * (anchor - eye);
  if (camera.GetParallelProjection()) {
    camera.SetParallelScale(camera.GetParallelScale() / factor);
    const Vector3 forward = Vector3(camera.GetDirectionOfProjection()).normalized();
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
  return Vector3(renderer.GetDisplayPoint());
}

Vector3 atDepthOf(vtkRenderer& renderer, const Vector3& reference, const DisplayPoint& display)
{
  renderer.SetDisplayPoint(display.x(), display.y(), toDisplay(renderer, reference).z());
  renderer.DisplayToWorld();
  const double* world = renderer.GetWorldPoint();
  return Vector3(world) / world[3];
}

ViewFrame frameOf(vtkCamera& camera)
{
  const Vector3 back = -Vector3(camera.GetDirectionOfProjection()).normalized();
  const Vector3 right = Vector3(camera.GetViewUp()).cross(back).normalized();
  return {right, back.cross(right), back};
}

ViewFrame defaultFrame(const Positions& positions, UpAxis up)
{
  const Vector3 sizes = boundingBox(positions).sizes();
  const double height = up == UpAxis::Z ? sizes.z() : sizes.y();
  const double depth = up == UpAxis::Z ? sizes.y() : sizes.z();
  const double longest = std::max(sizes.x(), depth);
  const double rise = (height < kFlat * longest ? kRiseOverFlatDegrees : kRiseDegrees) * kDegree;
  const double turn = (depth > sizes.x() ? -kTurnDegrees : kTurnDegrees - 90) * kDegree;
  const Vector3 back(std::cos(rise) * std::cos(turn), std::cos(rise) * std::sin(turn), std::sin(rise));
  const Vector3 right = Vector3::UnitZ().cross(back).normalized();
  return {upright(up, right), upright(up, back.cross(right)), upright(up, back)};
}

void fit(vtkCamera& camera, const ViewFrame& frame, const Positions& points, double aspect, const FreeSides& free)
{
  // Planes of these slopes through the eye have all points between them. In a parallel projection they are parallel,
  // and its half height takes the place of the eye's distance.
  const bool isParallel = camera.GetParallelProjection() != 0;
  const double lens = std::tan(kViewAngleDegrees / 2 * kDegree);
  const double perHeight = isParallel ? 1 : lens;
  const double perDepth = isParallel ? 0 : 1;
  const double slope = perHeight * (1 - 2 * kMargin);
  const double slopeLeft = perHeight * (1 - 2 * std::max(kMargin, free.left)) * aspect;
  const double slopeRight = perHeight * (1 - 2 * std::max(kMargin, free.right)) * aspect;
  const Vector3 back = perDepth * frame.back;
  Eigen::Matrix<double, 3, 6> directions;
  directions << slopeRight * back + frame.right, slopeLeft * back - frame.right, slope * back + frame.up,
      slope * back - frame.up, frame.back, -frame.back;
  // A product of matrices would hold all points six times.
  const Eigen::RowVector<double, 6> reach = points.lazyProduct(directions).colwise().maxCoeff();
  const double nearest = reach[4];
  const double farthest = -reach[5];
  // A single point has no size to fit: any distance from it will do.
  const double size = std::max((reach[0] + reach[1]) / (slopeRight + slopeLeft), (reach[2] + reach[3]) / (2 * slope));
  const double extent = size - perDepth * nearest > 0 ? size : perDepth * nearest + 1;
  const double eyeBack = isParallel ? nearest + extent / lens : extent;
  const Vector3 across = ((reach[0] - reach[1]) + (slopeLeft - slopeRight) * extent) / 2 * frame.right +
                         (reach[2] - reach[3]) / 2 * frame.up;
  const Vector3 eye = across + eyeBack * frame.back;
  const Vector3 focus = across + (farthest + nearest) / 2 * frame.back;
  camera.SetViewAngle(kViewAngleDegrees);
  camera.SetPosition(eye.data());
  camera.SetFocalPoint(focus.data());
  if (isParallel) camera.SetParallelScale(extent);
  setViewUp(camera, frame.up);
}

}  // namespace holdfast
