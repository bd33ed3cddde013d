#include "widgets/plain_view.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>
#include <vtkCamera.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

namespace holdfast::test {
namespace {

constexpr double kViewAngle = 30;     // degrees, from the bottom to the top
constexpr double kParallelScale = 2;  // from the middle to the top
constexpr double kDoubt = 1e-9;

struct Frame {
  Vector3 right;
  Vector3 up;
  Vector3 forward;
};

Frame frameOf(const PlainView& view)
{
  const Vector3 forward = (view.target - view.eye).normalized();
  const Vector3 right = forward.cross(Vector3::UnitY()).normalized();
  return {right, right.cross(forward), forward};
}

/// The line of sight through a point of the screen: from the place at depth 1 towards that at depth 2, depth grows
/// evenly.
struct Line {
  Line(const PlainView& view, const Eigen::Vector2d& point)
      : origin(view.placeAt(point, 1)), step(view.placeAt(point, 2) - origin)
  {
  }

  Vector3 origin;
  Vector3 step;
};

/// A triangle on such a line: its depth there, and the weights of its corners in space.
struct Crossing {
  double depth = 0;
  Vector3 weights = Vector3::Zero();
};

Crossing crossingOf(const Line& line, const Positions& positions, const Triangle& triangle)
{
  const Vector3 a = positions.row(triangle[0]);
  const Vector3 b = positions.row(triangle[1]);
  const Vector3 c = positions.row(triangle[2]);
  const Vector3 normal = (b - a).cross(c - a);
  const double along = (a - line.origin).dot(normal) / line.step.dot(normal);
  const Vector3 place = line.origin + along * line.step;
  const auto share = [&](const Vector3& from, const Vector3& to) {
    return (to - from).cross(place - from).dot(normal) / normal.squaredNorm();
  };
  return {1 + along, {share(b, c), share(c, a), share(a, b)}};
}

}  // namespace

double PlainView::pixelsAt(double depth) const
{
  const double half = height / 2.0;
  return projection == Projection::Parallel ? half / kParallelScale
                                            : half / std::tan(kViewAngle / 2 * std::numbers::pi / 180) / depth;
}

Vector3 PlainView::shown(const Vector3& place) const
{
  const Frame frame = frameOf(*this);
  const Vector3 seen = place - eye;
  const double depth = seen.dot(frame.forward);
  const double pixels = pixelsAt(depth);
  return {width / 2.0 + pixels * seen.dot(frame.right), height / 2.0 + pixels * seen.dot(frame.up), depth};
}

Vector3 PlainView::placeAt(const Eigen::Vector2d& point, double depth) const
{
  const Frame frame = frameOf(*this);
  const double pixels = pixelsAt(depth);
  return eye + depth * frame.forward + (point.x() - width / 2.0) / pixels * frame.right +
         (point.y() - height / 2.0) / pixels * frame.up;
}

PlainScreen::PlainScreen(const PlainView& view)
{
  window_->SetOffScreenRendering(1);
  window_->AddRenderer(renderer_);
  look(view);
}

PlainScreen::~PlainScreen() = default;

void PlainScreen::look(const PlainView& view)
{
  window_->SetSize(view.width, view.height);
  test::look(*renderer_->GetActiveCamera(), view);
}

void look(vtkCamera& camera, const PlainView& view)
{
  camera.SetPosition(view.eye.data());
  camera.SetFocalPoint(view.target.data());
  camera.SetViewUp(0, 1, 0);
  camera.SetViewAngle(kViewAngle);
  camera.SetParallelScale(kParallelScale);
  camera.SetParallelProjection(view.projection == Projection::Parallel ? 1 : 0);
}

PlainSight plainSight(const PlainView& view, const Eigen::Vector2d& point, const Positions& positions,
                      const std::vector<Triangle>& triangles)
{
  const Line line(view, point);
  PlainSight sight;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto [depth, weights] = crossingOf(line, positions, triangles[t]);
    const bool isEdge = std::abs(weights.minCoeff()) < kDoubt;
    if (isEdge && depth > 0) sight.isDoubtful = true;
    if (!(depth > 0) || weights.minCoeff() < 0 || depth >= nearest) continue;
    nearest = depth;
    sight.triangle = static_cast<Index>(t);
    sight.weights = weights;
  }
  return sight;
}

std::optional<bool> isPlainlyVisible(const PlainView& view, const Vector3& place, const std::vector<Index>& own,
                                     const Positions& positions, const std::vector<Triangle>& triangles)
{
  const Vector3 shown = view.shown(place);
  if (shown[2] <= 0) return false;
  const Line line(view, shown.head<2>());
  bool isDoubtful = false;
  for (const Triangle& triangle : triangles) {
    if (std::all_of(own.begin(), own.end(),
                    [&](Index v) { return std::find(triangle.begin(), triangle.end(), v) != triangle.end(); }))
      continue;
    const auto [depth, weights] = crossingOf(line, positions, triangle);
    if (!(depth > 0) || weights.minCoeff() < -kDoubt || depth > shown[2] * (1 + kDoubt)) continue;
    if (weights.minCoeff() > kDoubt && depth < shown[2] * (1 - kDoubt)) return false;
    isDoubtful = true;
  }
  return isDoubtful ? std::nullopt : std::optional(true);
}

}  // namespace holdfast::test
