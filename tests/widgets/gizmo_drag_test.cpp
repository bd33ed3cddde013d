#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <holdfast/widgets/gizmo/gizmo_drag.h>

#include "support/point_constraints.h"
#include "widgets/view_without_window.h"

namespace holdfast {
namespace {

using std::numbers::pi;
using test::Projection;

// Roundings of a ray, magnified by the distance of the eye.
constexpr double kRoundedOff = 1e-9;

DisplayTransform viewFrom(const Vector3& direction, Projection projection, const Vector3& at = Vector3::Zero())
{
  test::ViewWithoutWindow fixture;
  fixture.lookFrom(direction, at, projection);
  return fixture.view();
}

GizmoFrame rotatedFrame()
{
  return {{0.2, -0.1, 0.3}, Eigen::AngleAxisd(0.7, Vector3(1, 2, -1).normalized()).matrix()};
}

DisplayPoint seen(const DisplayTransform& view, const Vector3& place)
{
  return *toDisplay(view, place);
}

constexpr std::array kProjections{Projection::Perspective, Projection::Parallel};

TEST(GizmoDrag, BeginsWithExactlyNothingWhereverItIsGrabbed)
{
  for (const Projection projection : kProjections) {
    const DisplayTransform view = viewFrom({3, -4, 2}, projection);
    for (int k = 1; k < kGizmoPartCount; ++k)
      for (const Snap snap : {Snap::None, Snap::On}) {
        const DisplayPoint start = seen(view, rotatedFrame().center) + DisplayPoint(31.7, -18.3);
        GizmoDrag drag(static_cast<GizmoPart>(k), rotatedFrame(), view, start);
        const GizmoMotion motion = drag.to(start, snap);
        EXPECT_EQ(motion.translation, Vector3(0, 0, 0)) << k;
        EXPECT_EQ(motion.degrees, 0) << k;
        EXPECT_EQ(motion.distance, 0) << k;
        EXPECT_NEAR(motion.axis.norm(), 1, 1e-14);
      }
  }
}

TEST(GizmoDrag, ArrowsFollowThePlaceThatWasGrabbed)
{
  const GizmoFrame frame = rotatedFrame();
  for (const Projection projection : kProjections) {
    const DisplayTransform view = viewFrom({3, -4, 2}, projection);
    for (int axis = 0; axis < 3; ++axis) {
      const Vector3 along = frame.axes.col(axis);
      const auto part = static_cast<GizmoPart>(static_cast<int>(GizmoPart::ArrowX) + axis);
      GizmoDrag drag(part, frame, view, seen(view, frame.center + 0.4 * along));
      for (const double way : {0.3, -0.9, 1.7}) {
        const GizmoMotion motion = drag.to(seen(view, frame.center + (0.4 + way) * along), Snap::None);
        EXPECT_LT((motion.translation - way * along).norm(), kRoundedOff);
        EXPECT_NEAR(motion.distance, way, kRoundedOff);
        EXPECT_EQ(motion.degrees, 0);
      }
    }
  }
}

TEST(GizmoDrag, SquaresAndTheCenterFollowThePlaceThatWasGrabbed)
{
  const GizmoFrame frame = rotatedFrame();
  for (const Projection projection : kProjections) {
    const DisplayTransform view = viewFrom({3, -4, 2}, projection);
    for (int axis = 0; axis < 4; ++axis) {
      const Vector3 u = axis < 3 ? Vector3(frame.axes.col((axis + 1) % 3)) : view.right();
      const Vector3 v = axis < 3 ? Vector3(frame.axes.col((axis + 2) % 3)) : view.up();
      const auto part =
          axis < 3 ? static_cast<GizmoPart>(static_cast<int>(GizmoPart::SquareX) + axis) : GizmoPart::Center;
      const Vector3 grabbed = frame.center + 0.1 * u + 0.15 * v;
      GizmoDrag drag(part, frame, view, seen(view, grabbed));
      const GizmoMotion motion = drag.to(seen(view, grabbed + 0.6 * u - 0.4 * v), Snap::None);
      EXPECT_LT((motion.translation - (0.6 * u - 0.4 * v)).norm(), kRoundedOff);
      EXPECT_NEAR(motion.distance, std::hypot(0.6, 0.4), kRoundedOff);
    }
  }
}

/// A place on a ring about the frame's axis, or the view's.
struct Circle {
  Vector3 center;
  Vector3 axis;
  double radius;

  [[nodiscard]] Vector3 at(double degrees) const
  {
    const Vector3 first = axis.unitOrthogonal();
    return center + radius * (Eigen::AngleAxisd(degrees * pi / 180, axis) * first);
  }
};

TEST(GizmoDrag, RingsFollowTheCursorOverSeveralTurns)
{
  const GizmoFrame frame = rotatedFrame();
  for (const Projection projection : kProjections)
    for (const Vector3& from : {Vector3(3, -4, 2), Vector3(-3, 4, -2)}) {
      const DisplayTransform view = viewFrom(from, projection);
      for (int axis = 0; axis < 4; ++axis) {
        const Circle circle{frame.center, axis < 3 ? Vector3(frame.axes.col(axis)) : Vector3(-view.direction()), 0.8};
        if (std::abs(circle.axis.dot(view.direction())) < 0.4) continue;
        const auto part =
            axis < 3 ? static_cast<GizmoPart>(static_cast<int>(GizmoPart::RingX) + axis) : GizmoPart::ViewRing;
        GizmoDrag drag(part, frame, view, seen(view, circle.at(40)));
        GizmoMotion motion;
        for (double degrees = 0; degrees <= 1080; degrees += 30)
          motion = drag.to(seen(view, circle.at(40 + degrees)), Snap::None);
        EXPECT_NEAR(motion.degrees, 1080, 1e-7);
        for (double degrees = 1080; degrees >= -400; degrees -= 40)
          motion = drag.to(seen(view, circle.at(40 + degrees)), Snap::None);
        EXPECT_NEAR(motion.degrees, -400, 1e-7);
        EXPECT_LT((motion.axis - circle.axis).norm(), 1e-14);
        EXPECT_EQ(motion.translation, Vector3(0, 0, 0));
      }
    }
}

TEST(GizmoDrag, RingsSayWhereTheyWereGrabbed)
{
  const GizmoFrame frame = rotatedFrame();
  const DisplayTransform view = viewFrom({3, -4, 2}, Projection::Perspective);
  const Vector3 arm = (frame.axes * Vector3(0.6, 0.8, 0));
  ASSERT_GT(std::abs(frame.axes.col(2).dot(view.direction())), 0.3);
  EXPECT_LT((GizmoDrag(GizmoPart::RingZ, frame, view, seen(view, frame.center + 0.5 * arm)).grabbed() - arm).norm(),
            kRoundedOff);
}

TEST(GizmoDrag, RingsSeenFromTheSideRollWithTheCursor)
{
  for (const Projection projection : kProjections) {
    const DisplayTransform view = viewFrom({0.05, -1, 0.1}, projection);
    const DisplayPoint start = seen(view, {0, 0, 0}) + DisplayPoint(20, 0);
    GizmoDrag drag(GizmoPart::RingZ, {}, view, start, 100);
    // The front goes to the right: counterclockwise seen from above.
    const double length = 100 * pi;
    EXPECT_NEAR(drag.to(start + DisplayPoint(length, 0), Snap::None).degrees, 180, 0.1);
    EXPECT_NEAR(drag.to(start + DisplayPoint(4 * length, 0), Snap::None).degrees, 720, 0.5) << "no cursor is too far";
    EXPECT_NEAR(drag.to(start + DisplayPoint(-length / 2, 300), Snap::None).degrees, -90, 0.1);
    EXPECT_EQ(drag.to(start, Snap::None).degrees, 0);
    EXPECT_GT(drag.grabbed().dot(-view.direction()), 0.99) << "held in front";
  }
}

TEST(GizmoDrag, SnapsToExactMultiples)
{
  const DisplayTransform view = viewFrom({3, -4, 2}, Projection::Perspective);
  const Circle circle{{0, 0, 0}, Vector3::UnitZ(), 0.8};
  GizmoDrag ring(GizmoPart::RingZ, {}, view, seen(view, circle.at(3)));
  EXPECT_EQ(ring.to(seen(view, circle.at(3 + 14)), Snap::On).degrees, 15);
  EXPECT_EQ(ring.to(seen(view, circle.at(3 + 101)), Snap::On).degrees, 105);
  EXPECT_EQ(ring.to(seen(view, circle.at(3 + 233)), Snap::On).degrees, 240);
  EXPECT_EQ(ring.to(seen(view, circle.at(3 + 364)), Snap::On).degrees, 360);
  const GizmoMotion back = ring.to(seen(view, circle.at(3 - 4)), Snap::On);
  EXPECT_EQ(back.degrees, 360);

  const DisplayTransform across = viewFrom({1, -4, 2}, Projection::Perspective);
  GizmoDrag arrow(GizmoPart::ArrowX, {}, across, seen(across, {0.1, 0, 0}));
  ASSERT_EQ(arrow.step().size(), 0.1) << "a pixel is 1/90 of a unit";
  EXPECT_EQ(arrow.to(seen(across, {0.41, 0, 0}), Snap::On).translation, Vector3(0.3, 0, 0));
  EXPECT_EQ(arrow.to(seen(across, {0.82, 0, 0}), Snap::On).translation, Vector3(0.7, 0, 0));
  EXPECT_FALSE(std::signbit(arrow.to(seen(across, {0.09, 0, 0}), Snap::On).distance));
  GizmoDrag square(GizmoPart::SquareZ, {}, view, seen(view, {0.1, 0.1, 0}));
  const double step = square.step().size();
  EXPECT_EQ(square.to(seen(view, {0.1 + 3.2 * step, 0.1 - 2.1 * step, 0}), Snap::On).translation,
            Vector3(square.step().multiple(3), square.step().multiple(-2), 0));
}

TEST(GizmoDrag, StepsAreRoundAndAtLeastEightPixels)
{
  test::Random random(4);
  for (int k = 0; k < 100; ++k) {
    const double least = std::pow(10, random.uniform(-12, 12));
    const RoundStep step = roundStepFrom(least);
    EXPECT_GE(step.size(), least);
    EXPECT_LE(step.size(), 2.5 * least * (1 + 1e-12));
    EXPECT_TRUE(step.factor == 1 || step.factor == 2 || step.factor == 5);
  }
  EXPECT_EQ(roundStepFrom(0.1).multiple(3), 0.3);
  EXPECT_EQ(roundStepFrom(0.15).multiple(7), 1.4);
  EXPECT_EQ(roundStepFrom(3).multiple(-3), -15);
  EXPECT_EQ(roundStepFrom(60).size(), 100);
  EXPECT_GT(roundStepFrom(1e-300).size(), 0);
  const DisplayTransform view = viewFrom({3, -4, 2}, Projection::Parallel);
  for (int k = 1; k <= static_cast<int>(GizmoPart::SquareZ); ++k) {
    const GizmoDrag drag(static_cast<GizmoPart>(k), {}, view, seen(view, {0, 0, 0}));
    EXPECT_GE(drag.step().size() * 120, 8) << "120 pixels a unit";
  }
}

TEST(GizmoDrag, StaysWhatItWasWhereTheCursorSaysNothing)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const DisplayTransform view = viewFrom({0.2, -1, 0.3}, Projection::Perspective);
  // Lines along y meet here; beyond are places behind the eye.
  const DisplayPoint vanishing = seen(view, 1e12 * Vector3::UnitY());
  for (const GizmoPart part : {GizmoPart::ArrowY, GizmoPart::SquareX, GizmoPart::SquareZ, GizmoPart::RingZ}) {
    GizmoDrag drag(part, {}, view, seen(view, {0, 0.2, 0}));
    const GizmoMotion good = drag.to(seen(view, {0, 0.5, 0}), Snap::None);
    EXPECT_EQ(drag.to({nan, 0}, Snap::None).translation, good.translation);
    EXPECT_EQ(drag.to({nan, nan}, Snap::None).degrees, good.degrees);
    for (double y = -4000; y < 4000; y += 7.3) {
      const GizmoMotion motion = drag.to(vanishing + DisplayPoint(0.01, y), Snap::None);
      ASSERT_TRUE(motion.translation.allFinite() && std::isfinite(motion.degrees));
      ASSERT_LT(motion.translation.norm(), 2000) << "not farther than rays at a degree to the axis reach";
    }
    EXPECT_EQ(drag.to(vanishing, Snap::None).translation, drag.to({nan, 0}, Snap::None).translation);
  }
}

TEST(GizmoDrag, AlongTheViewMovesNothing)
{
  for (const Projection projection : kProjections) {
    const DisplayTransform view = viewFrom({0, -1, 0}, projection);
    for (const GizmoPart part : {GizmoPart::ArrowY, GizmoPart::SquareX, GizmoPart::SquareZ}) {
      GizmoDrag drag(part, {}, view, seen(view, {0, 0, 0}));
      EXPECT_EQ(drag.to(seen(view, {0, 0, 0}), Snap::On).translation, Vector3(0, 0, 0));
      EXPECT_TRUE(drag.to(seen(view, {0, 0, 0}) + DisplayPoint(50, 40), Snap::None).translation.allFinite());
    }
  }
}

TEST(GizmoDrag, BehindTheEyeMovesNothing)
{
  const DisplayTransform view = viewFrom({0, -1, 0}, Projection::Perspective);
  for (int k = 1; k < kGizmoPartCount; ++k) {
    GizmoDrag drag(static_cast<GizmoPart>(k), {{0, -20, 0}, Eigen::Matrix3d::Identity()}, view, {300, 200});
    const GizmoMotion motion = drag.to({310, 260}, Snap::On);
    EXPECT_TRUE(motion.translation.allFinite() && std::isfinite(motion.degrees)) << k;
  }
}

TEST(GizmoDrag, TakesTypedValuesExactly)
{
  const DisplayTransform view = viewFrom({3, -4, 2}, Projection::Perspective);
  GizmoDrag arrow(GizmoPart::ArrowY, {}, view, seen(view, {0, 0.3, 0}));
  const GizmoMotion dragged = arrow.to(seen(view, {0, 0.9, 0}), Snap::None);
  EXPECT_EQ(arrow.typed(-12.7).translation, Vector3(0, -12.7, 0));
  EXPECT_EQ(arrow.typed(-12.7).distance, -12.7);
  EXPECT_EQ(arrow.to(seen(view, {0, 0.9, 0}), Snap::None).translation, dragged.translation);
  const GizmoDrag ring(GizmoPart::RingX, {}, view, seen(view, {0, 0.5, 0.5}));
  EXPECT_EQ(ring.typed(1080).degrees, 1080);
  EXPECT_EQ(ring.typed(1080).axis, Vector3(1, 0, 0));
  GizmoDrag square(GizmoPart::SquareZ, {}, view, seen(view, {0.2, 0.2, 0}));
  EXPECT_EQ(square.typed(3).translation, Vector3(3, 0, 0)) << "its first axis";
  (void)square.to(seen(view, {0.2 - 0.3, 0.2 + 0.4, 0}), Snap::None);
  EXPECT_LT((square.typed(10).translation - Vector3(-6, 8, 0)).norm(), 1e-7) << "as it was dragged";
}

TEST(GizmoDrag, IsToldInWords)
{
  const auto told = [](GizmoPart part, double amount, const RoundStep& step, const std::string& units) {
    return motionText(part, {{}, Vector3::UnitX(), amount, amount}, step, units);
  };
  EXPECT_EQ(told(GizmoPart::ArrowX, 12.5, {5, -1}, "mm"), "12.5 mm");
  EXPECT_EQ(told(GizmoPart::ArrowX, -12.5, {5, 0}, ""), "-12");
  EXPECT_EQ(told(GizmoPart::ArrowX, -0.004, {5, -1}, "mm"), "0.0 mm");
  EXPECT_EQ(told(GizmoPart::SquareX, 1.5e-9, {1, -10}, "m"), "1.5e-09 m");
  EXPECT_EQ(told(GizmoPart::RingX, 30, {5, -1}, "mm"), "30.0°");
  EXPECT_EQ(told(GizmoPart::ViewRing, -0.01, {5, -1}, "mm"), "0.0°");
  EXPECT_EQ(motionText(GizmoPart::ViewRing, {{}, Vector3(0.6, 1e-17, -0.8), 45, 0}, {5, -1}, "mm"),
            "45.0° about (0.6, 0, -0.8)");
}

}  // namespace
}  // namespace holdfast
