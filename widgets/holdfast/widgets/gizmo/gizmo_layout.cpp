#include "holdfast/widgets/gizmo/gizmo_layout.h"

#include <cmath>
#include <numbers>

namespace holdfast {
namespace {

using namespace gizmo_layout;

constexpr double kFar = std::numeric_limits<double>::infinity();
constexpr int kSegments = 96;

// Sines between which parts fade.
constexpr double kArrowGone = 0.10;
constexpr double kArrowFull = 0.24;
constexpr double kPlaneGone = 0.10;
constexpr double kPlaneFull = 0.22;
constexpr double kRingGone = 0.03;
constexpr double kRingFull = 0.10;

// Cosines of the angle between a ring's arm and the way to the eye.
constexpr double kBehind = -0.30;
constexpr double kInSight = -0.05;
constexpr double kFadedRing = 0.16;

double smoothStep(double low, double high, double value)
{
  const double t = std::clamp((value - low) / (high - low), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

double distanceToSegment(const DisplayPoint& point, const DisplayPoint& a, const DisplayPoint& b)
{
  const DisplayPoint along = b - a;
  const double length = along.squaredNorm();
  const double t = length > 0 ? std::clamp((point - a).dot(along) / length, 0.0, 1.0) : 0;
  return (point - a - t * along).norm();
}

/// Distances in pixels from one cursor.
struct Distances {
  const DisplayTransform& view;
  const GizmoPlacement& placement;
  const DisplayPoint& cursor;
  DisplayPoint center;
  double radius;  // of the outer ring, pixels

  [[nodiscard]] Vector3 place(const Vector3& local) const
  {
    return placement.frame.center + placement.scale * (placement.frame.axes * local);
  }

  [[nodiscard]] double to(GizmoPart part) const
  {
    switch (kindOf(part)) {
      case GizmoPartKind::Center:
        return std::max(0.0, (cursor - center).norm() - kBallRadius * radius);
      case GizmoPartKind::Arrow:
        return toLine(place(kShaftStart * Vector3::Unit(axisIndexOf(part))),
                      place(kArrowEnd * Vector3::Unit(axisIndexOf(part))));
      case GizmoPartKind::Square:
        return toSquare(axisIndexOf(part));
      case GizmoPartKind::Ring:
        return toRing(axisIndexOf(part));
      case GizmoPartKind::ViewRing:
        return std::abs((cursor - center).norm() - radius);
      case GizmoPartKind::None:
        break;
    }
    return kFar;
  }

 private:
  [[nodiscard]] double toLine(const Vector3& a, const Vector3& b) const
  {
    const std::optional<DisplayPoint> from = toDisplay(view, a);
    const std::optional<DisplayPoint> to = toDisplay(view, b);
    return from && to ? distanceToSegment(cursor, *from, *to) : kFar;
  }

  [[nodiscard]] double toSquare(int axis) const
  {
    const Vector3 u = Vector3::Unit((axis + 1) % 3);
    const Vector3 v = Vector3::Unit((axis + 2) % 3);
    const std::array<Vector3, 4> corners{kSquareStart * (u + v), kSquareEnd * u + kSquareStart * v,
                                         kSquareEnd * (u + v), kSquareStart * u + kSquareEnd * v};
    double nearest = kFar;
    int inside = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const std::optional<DisplayPoint> a = toDisplay(view, place(corners[k]));
      const std::optional<DisplayPoint> b = toDisplay(view, place(corners[(k + 1) % 4]));
      if (!a || !b) return kFar;
      nearest = std::min(nearest, distanceToSegment(cursor, *a, *b));
      const DisplayPoint edge = *b - *a;
      const DisplayPoint arm = cursor - *a;
      inside += edge.x() * arm.y() - edge.y() * arm.x() > 0 ? 1 : -1;
    }
    return std::abs(inside) == 4 ? 0 : nearest;
  }

  [[nodiscard]] double toRing(int axis) const
  {
    const Vector3 u = Vector3::Unit((axis + 1) % 3);
    const Vector3 v = Vector3::Unit((axis + 2) % 3);
    const Vector3 sight = view.sightOf(placement.frame.center);
    const auto arm = [&](int k) {
      const double angle = 2 * std::numbers::pi * k / kSegments;
      return Vector3(std::cos(angle) * u + std::sin(angle) * v);
    };
    double nearest = kFar;
    for (int k = 0; k < kSegments; ++k)
      if (ringVisibility(placement.frame.axes * arm(k), sight) >= kLeastVisible)
        nearest = std::min(nearest, toLine(place(kRingRadius * arm(k)), place(kRingRadius * arm(k + 1))));
    return nearest;
  }
};

}  // namespace

GizmoPlacement placementOf(const DisplayTransform& view, const GizmoFrame& frame, double pixels)
{
  return {frame, pixels * view.worldPerPixel(frame.center)};
}

double visibilityOf(GizmoPart part, const GizmoFrame& frame, const DisplayTransform& view)
{
  const int axis = axisIndexOf(part);
  if (axis < 0) return part == GizmoPart::None ? 0 : 1;
  const double cosine = std::abs(frame.axes.col(axis).dot(view.sightOf(frame.center)));
  if (kindOf(part) == GizmoPartKind::Arrow)
    return smoothStep(kArrowGone, kArrowFull, std::sqrt(std::max(0.0, 1 - cosine * cosine)));
  if (kindOf(part) == GizmoPartKind::Square) return smoothStep(kPlaneGone, kPlaneFull, cosine);
  return smoothStep(kRingGone, kRingFull, cosine);
}

double ringVisibility(const Vector3& arm, const Vector3& sight)
{
  return kFadedRing + (1 - kFadedRing) * smoothStep(kBehind, kInSight, -arm.dot(sight));
}

GizmoPart hitGizmo(const DisplayTransform& view, const GizmoPlacement& placement, const DisplayPoint& cursor)
{
  const std::optional<DisplayPoint> center = toDisplay(view, placement.frame.center);
  if (!center || !(placement.scale > 0)) return GizmoPart::None;
  const double radius = placement.scale / view.worldPerPixel(placement.frame.center);
  const Distances distances{view, placement, cursor, *center, radius};
  GizmoPart hit = GizmoPart::None;
  double nearest = kTolerance * radius;
  for (int k = 1; k < kGizmoPartCount; ++k) {
    const auto part = static_cast<GizmoPart>(k);
    if (hit != GizmoPart::None && kindOf(part) != kindOf(hit)) break;
    if (visibilityOf(part, placement.frame, view) < kLeastVisible) continue;
    const double distance = distances.to(part);
    // The first of equals: what is inside a square is at no distance from it.
    if (distance < nearest || (hit == GizmoPart::None && distance == nearest)) {
      hit = part;
      nearest = distance;
    }
  }
  return hit;
}

}  // namespace holdfast
