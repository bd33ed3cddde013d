#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <holdfast/widgets/gizmo/gizmo_layout.h>
#include <holdfast/widgets/gizmo/gizmo_part_actors.h>

#include "support/point_constraints.h"
#include "widgets/lab_color.h"
#include "widgets/view_without_window.h"

namespace holdfast {
namespace {

using test::LabColor;
using test::toLab;

using namespace gizmo_layout;
using std::numbers::pi;
using test::Projection;

constexpr double kPixels = 100;

/// A gizmo at the origin, seen so that no part is faded.
struct Seen {
  DisplayTransform view;
  GizmoPlacement placement;

  explicit Seen(const Vector3& from = {1.2, 1.5, 1.1}, Projection projection = Projection::Perspective)
  {
    test::ViewWithoutWindow fixture;
    fixture.lookFrom(from, {0.3, 0.2, 0}, projection);
    view = fixture.view();
    placement = placementOf(view, {}, kPixels);
  }

  /// Returns the pixel of a place that is given in radii of the outer ring.
  [[nodiscard]] DisplayPoint at(double x, double y, double z) const
  {
    return *toDisplay(view, placement.scale * Vector3(x, y, z));
  }

  [[nodiscard]] GizmoPart hit(const DisplayPoint& cursor) const { return hitGizmo(view, placement, cursor); }
};

TEST(GizmoLayout, HasTheSameSizeInPixelsAtAnyDistance)
{
  for (const Projection projection : {Projection::Perspective, Projection::Parallel})
    for (const double distance : {0.01, 1.0, 300.0}) {
      test::ViewWithoutWindow fixture;
      fixture.lookFrom({1, 2, 3}, (10 - distance) / std::sqrt(14) * Vector3(-1, -2, -3), projection);
      const DisplayTransform view = fixture.view();
      const GizmoPlacement placement = placementOf(view, {}, kPixels);
      const DisplayPoint center = *toDisplay(view, {0, 0, 0});
      for (const Vector3& across : {view.up(), view.right(), Vector3((view.up() + view.right()) / std::sqrt(2))})
        EXPECT_NEAR((*toDisplay(view, placement.scale * across) - center).norm(), kPixels, 1e-6);
    }
}

TEST(GizmoLayout, EveryPartIsHitWhereItIsDrawn)
{
  for (const Projection projection : {Projection::Perspective, Projection::Parallel}) {
    const Seen seen({1.2, 1.5, 1.1}, projection);
    const double square = (kSquareStart + kSquareEnd) / 2;
    EXPECT_EQ(seen.hit(seen.at(0, 0, 0)), GizmoPart::Center);
    EXPECT_EQ(seen.hit(seen.at(kHeadStart, 0, 0)), GizmoPart::ArrowX);
    EXPECT_EQ(seen.hit(seen.at(0, kHeadStart, 0)), GizmoPart::ArrowY);
    EXPECT_EQ(seen.hit(seen.at(0, 0, kHeadStart)), GizmoPart::ArrowZ);
    EXPECT_EQ(seen.hit(seen.at(0, square, square)), GizmoPart::SquareX);
    EXPECT_EQ(seen.hit(seen.at(square, 0, square)), GizmoPart::SquareY);
    EXPECT_EQ(seen.hit(seen.at(square, square, 0)), GizmoPart::SquareZ);
    const double r = kRingRadius;
    EXPECT_EQ(seen.hit(seen.at(0, r * std::cos(-0.35), r * std::sin(-0.35))), GizmoPart::RingX);
    EXPECT_EQ(seen.hit(seen.at(r * std::cos(-0.35), 0, r * std::sin(-0.35))), GizmoPart::RingY);
    EXPECT_EQ(seen.hit(seen.at(r * std::cos(-0.35), r * std::sin(-0.35), 0)), GizmoPart::RingZ);
    EXPECT_EQ(seen.hit(seen.at(0, 0, 0) + kPixels * DisplayPoint(0.6, -0.8)), GizmoPart::ViewRing);
    EXPECT_EQ(seen.hit(seen.at(0, 0, 0) + 1.2 * kPixels * DisplayPoint(0.6, -0.8)), GizmoPart::None);
  }
}

TEST(GizmoLayout, IsHitWithinSixPixels)
{
  const Seen seen;
  const DisplayPoint out(0.6, -0.8);
  const DisplayPoint onRing = seen.at(0, 0, 0) + kPixels * out;
  EXPECT_EQ(seen.hit(onRing + 5.9 * out), GizmoPart::ViewRing);
  EXPECT_EQ(seen.hit(onRing + 6.1 * out), GizmoPart::None);
  EXPECT_EQ(seen.hit(onRing - 5.9 * out), GizmoPart::ViewRing);
}

TEST(GizmoLayout, TheCenterComesBeforeArrowsAndArrowsBeforeRings)
{
  const Seen seen;
  EXPECT_EQ(seen.hit(seen.at(kShaftStart, 0, 0)), GizmoPart::Center);
  EXPECT_EQ(seen.hit(seen.at(kRingRadius, 0, 0)), GizmoPart::ArrowX) << "where two rings cross";
}

TEST(GizmoLayout, TheFarHalfOfARingIsFadedAndIsNotHit)
{
  const Seen seen({0, -1, 0.45});
  const double r = kRingRadius;
  EXPECT_EQ(seen.hit(seen.at(r * std::cos(-1.0), r * std::sin(-1.0), 0)), GizmoPart::RingZ);
  EXPECT_NE(seen.hit(seen.at(r * std::cos(2.1), r * std::sin(2.1), 0)), GizmoPart::RingZ);
  EXPECT_LT(ringVisibility({0, 1, 0}, seen.view.direction()), 0.3);
  EXPECT_EQ(ringVisibility({0, -1, 0}, seen.view.direction()), 1);
  EXPECT_EQ(ringVisibility({1, 0, 0}, {0, 1, 0}), 1) << "all of a ring that faces the eye";
}

TEST(GizmoLayout, WhatIsSeenEndOnIsGoneAndIsNotHit)
{
  test::ViewWithoutWindow fixture;
  fixture.lookFrom({0, -1, 0}, {0, 0, 0}, Projection::Parallel);
  const DisplayTransform view = fixture.view();
  EXPECT_EQ(visibilityOf(GizmoPart::ArrowY, {}, view), 0);
  EXPECT_EQ(visibilityOf(GizmoPart::ArrowX, {}, view), 1);
  for (const GizmoPart part : {GizmoPart::SquareX, GizmoPart::SquareZ, GizmoPart::RingX, GizmoPart::RingZ})
    EXPECT_EQ(visibilityOf(part, {}, view), 0);
  EXPECT_EQ(visibilityOf(GizmoPart::SquareY, {}, view), 1);
  EXPECT_EQ(visibilityOf(GizmoPart::RingY, {}, view), 1);
  const GizmoPlacement placement = placementOf(view, {}, kPixels);
  EXPECT_EQ(hitGizmo(view, placement, *toDisplay(view, {0, 0, 0}) + DisplayPoint(30, -1)), GizmoPart::ArrowX);
  EXPECT_EQ(hitGizmo(view, placement, *toDisplay(view, {0, 0, 0}) + DisplayPoint(-30, 0)), GizmoPart::None)
      << "rings about x and z are edges here";
}

TEST(GizmoLayout, IsNowhereBehindTheEye)
{
  test::ViewWithoutWindow fixture;
  fixture.lookFrom({0, -1, 0}, {0, 0, 0}, Projection::Perspective);
  const GizmoPlacement placement = placementOf(fixture.view(), {{0, -30, 0}, Eigen::Matrix3d::Identity()}, kPixels);
  EXPECT_EQ(placement.scale, 0);
  EXPECT_EQ(hitGizmo(fixture.view(), placement, {320, 240}), GizmoPart::None);
}

TEST(GizmoShapes, AreLitFromOutsideAndWoundThatWay)
{
  for (int k = 1; k < kGizmoPartCount; ++k) {
    const GizmoShape shape = gizmoShape(static_cast<GizmoPart>(k));
    ASSERT_EQ(shape.normals.size(), shape.points.size());
    ASSERT_EQ(shape.opacities.size(), shape.points.size());
    for (const Vector3& normal : shape.normals) ASSERT_NEAR(normal.norm(), 1, 1e-12);
    for (const auto& [a, b, c] : shape.triangles) {
      const Vector3 normal = (shape.points[b] - shape.points[a]).cross(shape.points[c] - shape.points[a]);
      if (normal.norm() < 1e-9) continue;
      ASSERT_GT(normal.dot(shape.normals[a] + shape.normals[b] + shape.normals[c]), 0) << k;
    }
  }
}

TEST(GizmoShapes, LieWhereHitTestsExpectThem)
{
  for (int axis = 0; axis < 3; ++axis) {
    const auto shapeOf = [&](GizmoPart ofX) {
      return gizmoShape(static_cast<GizmoPart>(static_cast<int>(ofX) + axis));
    };
    double end = 0;
    for (const Vector3& point : shapeOf(GizmoPart::ArrowX).points) end = std::max(end, point[axis]);
    EXPECT_NEAR(end, kArrowEnd, 1e-12);
    for (const Vector3& point : shapeOf(GizmoPart::SquareX).points) {
      EXPECT_NEAR(point[axis], 0, 0.02);
      for (const int other : {(axis + 1) % 3, (axis + 2) % 3}) {
        EXPECT_GT(point[other], kSquareStart - 0.02);
        EXPECT_LT(point[other], kSquareEnd + 0.02);
      }
    }
    for (const Vector3& point : shapeOf(GizmoPart::RingX).points) EXPECT_NEAR(point.norm(), kRingRadius, 0.02);
  }
}

/// Lightness, red-green and blue-yellow without what a deuteranope cannot see (Viénot, Brettel, Mollon 1999).
LabColor asSeenByDeuteranopes(const Color& color)
{
  const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
  const auto encoded = [](double c) { return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055; };
  const double redGreen = 0.29275 * linear(color.red) + 0.70725 * linear(color.green);
  const double blue = -0.02234 * linear(color.red) + 0.02234 * linear(color.green) + linear(color.blue);
  return toLab({encoded(redGreen), encoded(redGreen), encoded(std::clamp(blue, 0.0, 1.0))});
}

TEST(GizmoColors, AreToldApartWithoutRedAndGreen)
{
  const std::vector<Color> colors{gizmoColor(GizmoPart::ArrowX), gizmoColor(GizmoPart::ArrowY),
                                  gizmoColor(GizmoPart::ArrowZ), kHighlightColor};
  for (std::size_t a = 0; a < colors.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) {
      const LabColor p = asSeenByDeuteranopes(colors[a]);
      const LabColor q = asSeenByDeuteranopes(colors[b]);
      EXPECT_GT(std::hypot(p.lightness - q.lightness, p.a - q.a, p.b - q.b), 20) << a << " and " << b;
    }
}

}  // namespace
}  // namespace holdfast
