#include "holdfast/widgets/camera/default_camera.h"

#include <algorithm>
#include <cmath>

#include <vtkCamera.h>

#include <holdfast/geometry/bounding_box.h>
#include <holdfast/geometry/degree.h>
#include <holdfast/widgets/camera/camera_state.h>

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

/// How far the points reach along each of the directions, in lengths of it.
template <int Count>
Eigen::Vector<double, Count> reachAlong(const Eigen::Matrix<double, 3, Count>& directions, const Positions& points)
{
  // A few at a time: products of all points would be a large matrix for a moment.
  constexpr Index kAtOnce = 512;
  Eigen::RowVector<double, Count> farthest = points.row(0) * directions;
  for (Index first = 0; first < points.rows(); first += kAtOnce) {
    const Index count = std::min(kAtOnce, points.rows() - first);
    const auto reached = (points.middleRows(first, count) * directions).colwise().maxCoeff();
    farthest = farthest.cwiseMax(reached);
  }
  return farthest.transpose();
}

/// Where the eye must be along one direction across the view, and how far back, to see all points between two planes
/// of slope `slope` through it.
struct Wedge {
  double across;
  double back;
};

/// From how far points reach along `slope` back + across and along `slope` back - across.
Wedge wedgeAround(double above, double below, double slope)
{
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
  const double slopeAcross = slope * aspect;
  Eigen::Matrix<double, 3, 6> directions;
  directions << slopeAcross * frame.back + frame.right, slopeAcross * frame.back - frame.right,
      slope * frame.back + frame.up, slope * frame.back - frame.up, frame.back, -frame.back;
  const Eigen::Vector<double, 6> reach = reachAlong(directions, points);
  const Wedge horizontal = wedgeAround(reach[0], reach[1], slopeAcross);
  const Wedge vertical = wedgeAround(reach[2], reach[3], slope);
  const double nearest = reach[4];
  const double farthest = -reach[5];
  // A single point has no size to fit: any distance from it will do.
  const double distance = std::max(horizontal.back, vertical.back) - nearest;
  const double eyeBack = nearest + (distance > 0 ? distance : 1);
  const Vector3 across = horizontal.across * frame.right + vertical.across * frame.up;
  const Vector3 eye = across + eyeBack * frame.back;
  const Vector3 focus = across + (farthest + nearest) / 2 * frame.back;
  camera.SetViewAngle(kViewAngleDegrees);
  camera.SetPosition(eye.data());
  camera.SetFocalPoint(focus.data());
  setViewUp(camera, frame.up);
}

}  // namespace holdfast
