#include "holdfast/view/default_camera.h"

#include <algorithm>
#include <cmath>

#include <vtkCamera.h>

#include <holdfast/base/degree.h>
#include <holdfast/mesh/bounding_box.h>

namespace holdfast {
namespace {

constexpr double kTurnDegrees = 32;
constexpr double kRiseDegrees = 24;

// What is flatter than this share of its length is looked at from higher up: its face is what there is to see.
constexpr double kFlat = 0.3;
constexpr double kRiseOverFlatDegrees = 36;

// A long lens: parallel edges stay nearly parallel.
constexpr double kViewAngleDegrees = 18;

// Of the picture's height and width.
constexpr double kMargin = 0.06;

/// Where the eye must be along one direction across the view, and how far back, to see all points between two planes
/// of slope `slope` through it.
struct Wedge {
  double across;
  double back;
};

Wedge wedgeAround(const Eigen::VectorXd& across, const Eigen::VectorXd& back, double slope)
{
  const double above = (across + slope * back).maxCoeff();
  const double below = (slope * back - across).maxCoeff();
  return {(above - below) / 2, (above + below) / (2 * slope)};
}

}  // namespace

ViewFrame defaultFrame(const Positions& positions)
{
  const Vector3 sides = boundingBox(positions).sizes();
  const bool isLongAlongY = sides.y() > sides.x();
  const double longest = std::max(sides.x(), sides.y());
  const double rise = (sides.z() < kFlat * longest ? kRiseOverFlatDegrees : kRiseDegrees) * kDegree;
  const double turn = (isLongAlongY ? -kTurnDegrees : kTurnDegrees - 90) * kDegree;
  const Vector3 back(std::cos(rise) * std::cos(turn), std::cos(rise) * std::sin(turn), std::sin(rise));
  const Vector3 right = Vector3::UnitZ().cross(back).normalized();
  return {right, back.cross(right), back};
}

void fit(vtkCamera& camera, const ViewFrame& frame, const Positions& points, double aspect)
{
  const double slope = std::tan(kViewAngleDegrees / 2 * kDegree) * (1 - 2 * kMargin);
  const Eigen::VectorXd back = points * frame.back;
  const Wedge horizontal = wedgeAround(points * frame.right, back, slope * aspect);
  const Wedge vertical = wedgeAround(points * frame.up, back, slope);
  // A single point has no size to fit: any distance from it will do.
  const double nearest = back.maxCoeff();
  const double distance = std::max(horizontal.back, vertical.back) - nearest;
  const double eyeBack = nearest + (distance > 0 ? distance : 1);
  const Vector3 across = horizontal.across * frame.right + vertical.across * frame.up;
  const Vector3 eye = across + eyeBack * frame.back;
  const Vector3 focus = across + (back.minCoeff() + nearest) / 2 * frame.back;
  camera.SetViewAngle(kViewAngleDegrees);
  camera.SetPosition(eye.data());
  camera.SetFocalPoint(focus.data());
  camera.SetViewUp(frame.up.data());
}

}  // namespace holdfast
