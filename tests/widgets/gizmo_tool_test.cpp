#include <QApplication>
#include <QEvent>
#include <QLineF>
#include <QTransform>
#include <algorithm>
#include <numbers>

#include <gmock/gmock.h>
#include <vtkRenderWindow.h>

#include <holdfast/base/degree.h>
#include <holdfast/document/list_edits.h>
#include <holdfast/rotation/rotation_log.h>
#include <holdfast/view/camera_motion.h>
#include <holdfast/widgets/tools/gizmo_tool.h>

#include "gestures.h"
#include "open_window.h"

namespace holdfast {
namespace {

/// The bracket with its measured points, of which one is selected.
class GizmoOnPoint : public test::OpenWindow {
 protected:
  void SetUp() override
  {
    OpenWindow::SetUp();
    open("bracket.obj", "bracket.constraints.json");
    point = *indexOf(list(), "flange east");
    editor().selectConstraints({point});
    ASSERT_TRUE(settle());
  }

  [[nodiscard]] QPointF shown(const Vector3& place)
  {
    return viewport().toPlace(toDisplay(viewport().renderer(), place).head<2>());
  }

  [[nodiscard]] Vector3 target() { return std::get<Target>(std::get<Point>(list().constraints[point].what).to).place; }

  /// On the shaft of an arrow of the gizmo.
  [[nodiscard]] QPointF onArrow(int axis)
  {
    const GizmoRepresentation& gizmo = window.gizmo().gizmo();
    const Vector3 along = gizmo.GetFrame().axes.col(axis);
    const Vector3 center = gizmo.GetFrame().center;
    const QPointF step = shown(center + along) - shown(center);
    const double pixels = std::hypot(step.x(), step.y());
    return shown(center + along * (0.5 * kGizmoPixels / pixels));
  }

  void dragArrow(int axis, const QPointF& by, Qt::KeyboardModifiers modifiers = Qt::NoModifier)
  {
    const QPointF from = onArrow(axis);
    test::drag(viewport(), {from, from + by / 3, from + by / 2, from + by}, Qt::LeftButton, modifiers);
    ASSERT_TRUE(settle());
  }

  Index point = 0;
};

TEST_F(GizmoOnPoint, AnArrowMovesTheTargetAlongItsAxisAlone)
{
  const Vector3 before = target();
  dragArrow(2, {0, -40});
  const Vector3 moved = target() - before;
  EXPECT_GT(moved.z(), 1);
  EXPECT_EQ(moved.x(), 0);
  EXPECT_EQ(moved.y(), 0);
}

TEST_F(GizmoOnPoint, TheSurfaceFollowsExactly)
{
  dragArrow(2, {0, -40});
  EXPECT_EQ(editor().freshness(), Freshness::Current);
  const auto& report = editor().deformation()->report;
  EXPECT_EQ(report.solve.status, SolveStatus::Ok);
  EXPECT_LE(report.solve.maxResidualRelative, 1e-12);
}

TEST_F(GizmoOnPoint, ADragIsOneEditThatUndoAndRedoBringBackBitForBit)
{
  const Positions before = editor().positions();
  dragArrow(0, {50, 10});
  const Positions after = editor().positions();
  ASSERT_NE(before, after);
  EXPECT_EQ(editor().history().undoName(), "move flange east");

  trigger("undo");
  ASSERT_TRUE(settle());
  EXPECT_EQ(editor().positions(), before);
  EXPECT_FALSE(editor().history().canUndo());
  trigger("redo");
  ASSERT_TRUE(settle());
  EXPECT_EQ(editor().positions(), after);
}

TEST_F(GizmoOnPoint, EscapeDuringADragRestoresExactlyWhatWas)
{
  const auto state = editor().history().state();
  const Positions before = editor().positions();
  const QPointF from = onArrow(2);
  test::pressMouse(viewport(), from);
  test::moveMouse(viewport(), from + QPointF(0, -50), Qt::LeftButton);
  ASSERT_TRUE(settle());
  ASSERT_NE(editor().positions(), before);
  trigger("escape");
  EXPECT_EQ(editor().history().state(), state);
  EXPECT_EQ(editor().positions(), before);
  test::moveMouse(viewport(), from + QPointF(0, -80), Qt::LeftButton);
  test::releaseMouse(viewport(), from + QPointF(0, -80));
  EXPECT_EQ(editor().history().state(), state) << "the rest of the gesture says nothing";
}

TEST_F(GizmoOnPoint, ControlSnapsToARoundLength)
{
  const double before = target().z();
  dragArrow(2, {0, -61}, Qt::ControlModifier);
  const double moved = target().z() - before;
  const double step = 1;  // mm, at this distance: 8 pixels or more
  const double steps = moved / step;
  EXPECT_GT(moved, 0);
  EXPECT_NEAR(steps, std::round(steps), 1e-9);
}

TEST_F(GizmoOnPoint, TheLabelStaysAtTheCursorAndInTheWindow)
{
  EXPECT_TRUE(window.gizmo().labelPlate().isEmpty());
  const QPointF from = onArrow(0);
  const QRectF room = viewport().rect();
  test::pressMouse(viewport(), from);
  for (const QPointF& cursor : {from + QPointF(30, 5), room.topRight(), room.bottomRight(), room.topLeft()}) {
    test::moveMouse(viewport(), cursor, Qt::LeftButton);
    const QRectF plate = window.gizmo().labelPlate();
    EXPECT_GT(plate.width(), 20);
    EXPECT_TRUE(room.contains(plate)) << cursor.x() << ", " << cursor.y();
    EXPECT_LT(QLineF(plate.center(), cursor).length(), 2 * plate.width()) << cursor.x() << ", " << cursor.y();
  }
  test::releaseMouse(viewport(), room.topLeft());
  EXPECT_TRUE(window.gizmo().labelPlate().isEmpty());
}

TEST_F(GizmoOnPoint, PointsHaveNoRings)
{
  const Vector3 center = window.gizmo().gizmo().GetFrame().center;
  const QPointF outer = shown(center) + QPointF(kGizmoPixels, 0);
  test::moveMouse(viewport(), outer);
  EXPECT_EQ(window.gizmo().gizmo().GetPart(), GizmoPart::None);
}

TEST_F(GizmoOnPoint, NoPartIsHighlightedOnceTheMouseHasLeft)
{
  test::moveMouse(viewport(), onArrow(2));
  EXPECT_EQ(window.gizmo().gizmo().GetPart(), GizmoPart::ArrowZ);
  QEvent leave(QEvent::Leave);
  QApplication::sendEvent(&viewport(), &leave);
  EXPECT_EQ(window.gizmo().gizmo().GetPart(), GizmoPart::None);
}

TEST_F(GizmoOnPoint, NothingStandsWhereNothingIsSelected)
{
  const auto isSeen = [this] { return viewport().renderWindow()->HasRenderer(window.gizmo().gizmo().GetLayer()) != 0; };
  EXPECT_TRUE(isSeen());
  editor().selectConstraints({});
  ASSERT_TRUE(settle());
  EXPECT_FALSE(window.gizmo().widget().GetEnabled());
  EXPECT_FALSE(isSeen());
  editor().selectConstraints({*indexOf(list(), "bolt rear left")});
  EXPECT_FALSE(window.gizmo().widget().GetEnabled()) << "what is fixed does not move";
}

/// The bar with a handle at its end.
class GizmoOnHandle : public GizmoOnPoint {
 protected:
  void SetUp() override
  {
    OpenWindow::SetUp();
    open("bar.obj", "bar.twist_90.constraints.json");
    for (Index k = 0; k < static_cast<Index>(list().constraints.size()); ++k)
      if (std::holds_alternative<Handle>(list().constraints[k].what)) point = k;
    editor().selectConstraints({point});
    ASSERT_TRUE(settle());
  }

  [[nodiscard]] double degrees()
  {
    return std::get<Turn>(std::get<Handle>(list().constraints[point].what).motion).degrees;
  }

  /// Takes the outer ring at its right and around the center by `degrees`, counterclockwise.
  void turnOuterRing(double degrees, Qt::KeyboardModifiers modifiers = Qt::NoModifier)
  {
    const QPointF middle = shown(window.gizmo().gizmo().GetFrame().center);
    std::vector<QPointF> way;
    for (int step = 0; step <= 80; ++step) {
      const double angle = degrees * kDegree * step / 80;
      way.push_back(middle + kGizmoPixels * QPointF(std::cos(angle), -std::sin(angle)));
    }
    test::drag(viewport(), way, Qt::LeftButton, modifiers);
    ASSERT_TRUE(settle());
  }

  /// What the handle at the end of the bar carries into the surface there.
  [[nodiscard]] double degreesOfTheSurface()
  {
    const Model& model = *editor().model();
    Index top = 0;
    model.mesh.positions.col(2).maxCoeff(&top);
    return angleDegrees(editor().deformation()->rotations.row(model.solverMesh.weld.unknownOf[top]).transpose());
  }
};

// Both ends of a drag are seen to half a pixel.
constexpr double kPixelInDegrees = 1 / kGizmoPixels / kDegree;

TEST_F(GizmoOnHandle, ARingTurnsItAsOftenAsTheCursorGoesRound)
{
  // About the axis of the handle, which makes 90 degrees already.
  trigger("viewTop");
  ASSERT_TRUE(settle());
  turnOuterRing(400);
  EXPECT_NEAR(degrees(), 490, kPixelInDegrees);
  EXPECT_NEAR(degreesOfTheSurface(), degrees(), 1e-9);
  EXPECT_EQ(editor().history().undoName().substr(0, 4), "turn");
  EXPECT_LE(editor().deformation()->report.solve.maxResidualRelative, 1e-12);
  turnOuterRing(-800);
  EXPECT_NEAR(degrees(), -310, 2 * kPixelInDegrees);
  const double before = degrees();
  turnOuterRing(751, Qt::ControlModifier);
  EXPECT_NEAR(degrees(), before + 750, 1e-9) << "steps of 15 degrees";
}

TEST_F(GizmoOnHandle, WhatTurnsAboutTheFixedEndIsDraggedRoundItWithoutAJump)
{
  ConstraintList changed = list();
  std::get<Handle>(changed.constraints[point].what).motion = TurnAboutFixed{};
  editor().edit("turn about the foot", changed);
  trigger("viewFront");
  ASSERT_TRUE(settle());
  const auto state = editor().history().state();
  const Positions before = editor().positions();
  const QPointF from = shown(window.gizmo().gizmo().GetFrame().center);
  const QPointF foot = shown({0, 0, 0});
  const auto goRound = [&](double turns) {
    test::pressMouse(viewport(), from);
    for (double degrees = 0; degrees <= 360 * turns; degrees += 5) {
      QTransform turn;
      turn.rotate(degrees);
      test::moveMouse(viewport(), foot + turn.map(from - foot), Qt::LeftButton);
    }
  };
  goRound(0.75);
  trigger("escape");
  ASSERT_TRUE(settle());
  EXPECT_EQ(editor().history().state(), state);
  EXPECT_EQ(editor().positions(), before);

  goRound(0.75);
  test::releaseMouse(viewport(), foot + QPointF(-(foot - from).y(), (foot - from).x()));
  ASSERT_TRUE(settle());
  const auto& near = std::get<TurnAboutFixed>(std::get<Handle>(list().constraints[point].what).motion).near;
  ASSERT_TRUE(near.has_value());
  EXPECT_NEAR(near->degrees, 270, 5);
  EXPECT_NEAR(editor().deformation()->system.rotations.back().q.norm() / std::numbers::pi * 360, near->degrees, 1e-9);
  EXPECT_LE(editor().deformation()->report.solve.maxResidualRelative, 1e-12);
  EXPECT_EQ(editor().history().undoName().substr(0, 4), "move");
  trigger("undo");
  ASSERT_TRUE(settle());
  EXPECT_EQ(editor().history().state(), state) << "a drag is one edit";
  EXPECT_EQ(editor().positions(), before);
}

}  // namespace
}  // namespace holdfast
