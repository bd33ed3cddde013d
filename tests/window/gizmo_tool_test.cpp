#include <QApplication>
#include <QEvent>
#include <QLineF>
#include <QTransform>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <vtkRenderWindow.h>

#include <holdfast/deform/deform.h>
#include <holdfast/deform/deform_details.h>
#include <holdfast/document/handle_restated.h>
#include <holdfast/document/list_edits.h>
#include <holdfast/geometry/rotation_log.h>
#include <holdfast/widgets/picking/surface_picker.h>
#include <holdfast/window/tools/gizmo_tool.h>

#include "gestures.h"
#include "open_window.h"

namespace holdfast {
namespace {

/// What is said of the constraint that is selected.
class GizmoInWindow : public test::OpenWindow {
 protected:
  [[nodiscard]] Vector3 target()
  {
    return std::get<Target>(std::get<PointConstraint>(list().constraints[point].what).to).place;
  }

  void dragArrow(int axis, const QPointF& by, Qt::KeyboardModifiers modifiers = Qt::NoModifier)
  {
    const QPointF from = onArrow(axis);
    test::drag(viewport(), {from, from + by / 3, from + by / 2, from + by}, Qt::LeftButton, modifiers);
    ASSERT_TRUE(settle());
  }

  Index point = 0;
};

/// The bracket with its measured points, of which one is selected.
class GizmoOnPoint : public GizmoInWindow {
 protected:
  void SetUp() override
  {
    OpenWindow::SetUp();
    open("bracket.obj", "bracket.constraints.json");
    point = *indexOf(list(), "flange east");
    editor().selectConstraints({point});
    ASSERT_TRUE(settle());
  }
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
  EXPECT_EQ(editor().solveState(), SolveState::Current);
  const auto& report = editor().deformation()->report;
  EXPECT_EQ(report.solve.status, SolveStatus::Ok);
  EXPECT_LE(report.solve.maxResidualRelative, 1e-12);
}

/// Rotations are found anew in every frame, from those of the frame before; the release finds what any program finds.
TEST_F(GizmoOnPoint, ADragFindsRotationsLiveAndAnewWhenItEnds)
{
  DeformOptions options = editor().state().options;
  options.rotations.source = RotationSource::Found;
  options.rotations.change = 1e-3;  // a few iterations
  editor().setOptions("choose where rotations come from", options);
  ASSERT_TRUE(settle());
  const QPointF from = onArrow(2);
  test::pressMouse(viewport(), from);
  Positions before = editor().positions();
  for (const double up : {20.0, 40.0}) {
    test::moveMouse(viewport(), from - QPointF(0, up), Qt::LeftButton);
    ASSERT_TRUE(settle());
    const SolveReport& solve = editor().deformation()->report.solve;
    EXPECT_NE(editor().positions(), before) << up;
    EXPECT_EQ(solve.status, SolveStatus::Ok);
    EXPECT_TRUE(solve.iterations.has_value());
    EXPECT_LE(solve.maxResidualRelative, 1e-12) << "in every frame";
    before = editor().positions();
  }
  test::releaseMouse(viewport(), from - QPointF(0, 40));
  ASSERT_TRUE(settle());
  EXPECT_TRUE(editor().deformation()->report.solve.iterations->isConverged);
  EXPECT_EQ(editor().positions(), deform(*editor().model(), list(), "constraints", options).positions);
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

TEST_F(GizmoOnPoint, TheLabelHasTheDigitsOfTheDrag)
{
  const QPointF from = onArrow(0);
  const auto decimals = [this, from](Qt::KeyboardModifiers modifiers) {
    test::moveMouse(viewport(), from + QPointF(33, 7), Qt::LeftButton, modifiers);
    const QString label = QString::fromStdString(window.gizmo().gizmo().GetLabel()).section(' ', 0, 0);
    return label.section('.', 1).size();
  };
  test::pressMouse(viewport(), from);
  const auto snapped = decimals(Qt::ControlModifier);
  EXPECT_EQ(decimals(Qt::NoModifier), snapped + 1) << "a pixel is about a tenth of a step";
  test::releaseMouse(viewport(), from);
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
  const QPointF outer = shownAt(center) + QPointF(kGizmoPixels, 0);
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
class GizmoOnHandle : public GizmoInWindow {
 protected:
  void SetUp() override
  {
    OpenWindow::SetUp();
    open("bar.obj", "bar.twist_90.constraints.json");
    for (Index k = 0; k < static_cast<Index>(list().constraints.size()); ++k)
      if (std::holds_alternative<HandleConstraint>(list().constraints[k].what)) point = k;
    editor().selectConstraints({point});
    ASSERT_TRUE(settle());
  }

  [[nodiscard]] double degrees()
  {
    return std::get<AxisRotation>(std::get<HandleConstraint>(list().constraints[point].what).motion).degrees;
  }

  /// Takes the outer ring at its right and around the center by `degrees`, counterclockwise.
  void turnOuterRing(double degrees, Qt::KeyboardModifiers modifiers = Qt::NoModifier)
  {
    const QPointF middle = shownAt(window.gizmo().gizmo().GetFrame().center);
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
  EXPECT_EQ(editor().history().undoName().substr(0, 6), "rotate");
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
  std::get<HandleConstraint>(changed.constraints[point].what).motion = RotationAboutFixed{};
  editor().edit("turn about the foot", changed);
  trigger("viewFront");
  ASSERT_TRUE(settle());
  const auto state = editor().history().state();
  const Positions before = editor().positions();
  const QPointF from = shownAt(window.gizmo().gizmo().GetFrame().center);
  const QPointF foot = shownAt({0, 0, 0});
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
  const auto& near =
      std::get<RotationAboutFixed>(std::get<HandleConstraint>(list().constraints[point].what).motion).near;
  ASSERT_TRUE(near.has_value());
  EXPECT_NEAR(near->degrees, 270, 5);
  EXPECT_NEAR(editor().deformation()->details->system.rotations.back().q.norm() / std::numbers::pi * 360, near->degrees,
              1e-9);
  EXPECT_LE(editor().deformation()->report.solve.maxResidualRelative, 1e-12);
  EXPECT_EQ(editor().history().undoName().substr(0, 4), "move");
  trigger("undo");
  ASSERT_TRUE(settle());
  EXPECT_EQ(editor().history().state(), state) << "a drag is one edit";
  EXPECT_EQ(editor().positions(), before);
}

/// The bar, whose free end has not turned yet, from the front.
class TurnOfMovesInMenu : public GizmoOnHandle {
 protected:
  void SetUp() override
  {
    GizmoOnHandle::SetUp();
    ConstraintList changed = list();
    std::get<AxisRotation>(std::get<HandleConstraint>(changed.constraints[point].what).motion).degrees = 0;
    editor().edit("stand upright", changed);
    trigger("viewFront");
    ASSERT_TRUE(settle());
  }

  [[nodiscard]] const HandleConstraint& handle() { return std::get<HandleConstraint>(list().constraints[point].what); }

  /// By the ball in the middle, across the view.
  void dragMiddle(const QPointF& way)
  {
    const QPointF from = shownAt(window.gizmo().gizmo().GetFrame().center);
    test::drag(viewport(), {from, from + way / 2, from + way});
    ASSERT_TRUE(settle());
  }

  /// Counterclockwise, of the way from the middle of the foot to the free end.
  [[nodiscard]] double degreesOnScreen()
  {
    const Model& model = *editor().model();
    Vector3 foot = Vector3::Zero();
    Index count = 0;
    for (const Vector3 place : model.mesh.positions.rowwise()) {
      if (place.z() > 5) continue;
      foot += place;
      ++count;
    }
    const QLineF way(shownAt(foot / static_cast<double>(count)), shownAt(window.gizmo().gizmo().GetFrame().center));
    return way.angle();
  }
};

TEST_F(TurnOfMovesInMenu, AMoveTurnsTheHandleAsItsConstraintSays)
{
  dragMiddle({-200, 30});
  EXPECT_GT(handle().translate.norm(), 10);
  EXPECT_EQ(degrees(), 0);
}

TEST_F(TurnOfMovesInMenu, AMoveTurnsTheHandleByTheAngleThatIsSeenWhereThatIsChosen)
{
  trigger("turnAsSeen");
  const double before = degreesOnScreen();
  dragMiddle({-200, 30});
  const double seen = degreesOnScreen() - before;
  ASSERT_GT(seen, 10);
  const AxisRotation& turn = std::get<AxisRotation>(handle().motion);
  EXPECT_NEAR(turn.degrees, seen, 1e-6);
  // From the front one looks along y: towards the eye it is counterclockwise.
  EXPECT_LT((turn.axis.normalized() + Vector3::UnitY()).norm(), 1e-9);
  EXPECT_LE(editor().deformation()->report.solve.maxResidualRelative, 1e-12);

  trigger("turnAsConstraint");
  dragMiddle({60, 0});
  EXPECT_NEAR(std::get<AxisRotation>(handle().motion).degrees, seen, 1e-6) << "turns no further";
}

TEST_F(TurnOfMovesInMenu, ARingTurnsAlikeInBoth)
{
  trigger("viewTop");
  ASSERT_TRUE(settle());
  turnOuterRing(40, Qt::ControlModifier);
  const double asConstraint = degrees();
  EXPECT_GT(std::abs(asConstraint), 20);
  trigger("undo");
  trigger("turnAsSeen");
  ASSERT_TRUE(settle());
  turnOuterRing(40, Qt::ControlModifier);
  EXPECT_EQ(degrees(), asConstraint);
}

TEST_F(GizmoOnHandle, ItsOwnAxesTurnWithIt)
{
  trigger("axesOwn");
  trigger("viewTop");
  ASSERT_TRUE(settle());
  const Eigen::Matrix3d before = window.gizmo().gizmo().GetFrame().axes;
  EXPECT_NEAR(std::abs(before(2, 2)), 1, 1e-9) << "along the bar";
  const double degreesBefore = degrees();
  turnOuterRing(30, Qt::ControlModifier);
  const double rotated = degrees() - degreesBefore;
  ASSERT_GT(std::abs(rotated), 10);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(rotated * kDegree, Vector3::UnitZ()).toRotationMatrix();
  EXPECT_LT((window.gizmo().gizmo().GetFrame().axes - turn * before).norm(), 1e-9);

  // Across both axes of the world.
  const Vector3 along = window.gizmo().gizmo().GetFrame().axes.col(0);
  ASSERT_GT(along.head<2>().cwiseAbs().minCoeff(), 0.2);
  const auto translate = [&] { return std::get<HandleConstraint>(list().constraints[point].what).translate; };
  const Vector3 placeBefore = translate();
  const QPointF from = onArrow(0);
  const QPointF way = from - shownAt(window.gizmo().gizmo().GetFrame().center);
  test::drag(viewport(), {from, from + way / 2, from + way});
  ASSERT_TRUE(settle());
  const Vector3 moved = translate() - placeBefore;
  EXPECT_GT(moved.dot(along), 0.5);
  EXPECT_LT(moved.cross(along).norm(), 1e-9 * moved.norm());
}

TEST_F(GizmoOnPoint, ItsOwnAxesFollowTheSurface)
{
  trigger("axesOwn");
  ASSERT_TRUE(settle());
  const Eigen::Matrix3d before = window.gizmo().gizmo().GetFrame().axes;
  dragArrow(2, {0, -60});
  const auto& surfacePoint = std::get<PointConstraint>(list().constraints[point].what);
  const Eigen::Matrix3d expected =
      surfaceAxes(*editor().model(), pointOf(surfacePoint.at, editor().model()->mesh), editor().positions());
  const Eigen::Matrix3d after = window.gizmo().gizmo().GetFrame().axes;
  EXPECT_GT((after - before).norm(), 1e-3) << "the flange bends";
  EXPECT_EQ(after, expected);

  const Vector3 placeBefore = target();
  dragArrow(0, (onArrow(0) - shownAt(window.gizmo().gizmo().GetFrame().center)));
  const Vector3 moved = target() - placeBefore;
  EXPECT_GT(moved.dot(after.col(0)), 0.1);
  EXPECT_LT(moved.cross(after.col(0)).norm(), 1e-9 * moved.norm());
}

}  // namespace
}  // namespace holdfast
