#include <numbers>

#include <gtest/gtest.h>

#include <holdfast/document/list_edits.h>
#include <holdfast/window/tools/gizmo_tool.h>

#include "gestures.h"
#include "window_user.h"

namespace holdfast {
namespace {

/// The bracket with its measured points, of which one is selected.
class NumberTypedAtAPoint : public test::WindowUser {
 protected:
  void SetUp() override
  {
    WindowUser::SetUp();
    open("bracket.obj", "bracket.constraints.json");
    point = *indexOf(list(), "flange east");
    editor().selectConstraints({point});
    ASSERT_TRUE(settle());
    viewport().setFocus();
  }

  [[nodiscard]] Vector3 target()
  {
    return std::get<Target>(std::get<PointConstraint>(list().constraints[point].what).to).place;
  }

  Index point = 0;
};

/// The bar with a handle at its end.
class NumberTypedAtAHandle : public test::WindowUser {
 protected:
  void SetUp() override
  {
    WindowUser::SetUp();
    open("bar.obj", "bar.twist_90.constraints.json");
    for (Index k = 0; k < static_cast<Index>(list().constraints.size()); ++k)
      if (std::holds_alternative<HandleConstraint>(list().constraints[k].what)) constraint = k;
    editor().selectConstraints({constraint});
    ASSERT_TRUE(settle());
    viewport().setFocus();
  }

  [[nodiscard]] const HandleConstraint& handle()
  {
    return std::get<HandleConstraint>(list().constraints[constraint].what);
  }

  Index constraint = 0;
};

TEST_F(NumberTypedAtAPoint, ATypedLengthMovesByExactlyThatMuchWithoutADrag)
{
  const auto state = editor().history().state();
  const Vector3 before = target();
  test::moveMouse(viewport(), onArrow(2));
  keys("12.5");
  EXPECT_EQ(target(), Vector3(before + Vector3(0, 0, 12.5))) << "seen while it is typed";
  key(Qt::Key_Return);
  EXPECT_EQ(target(), Vector3(before + Vector3(0, 0, 12.5)));
  EXPECT_EQ(editor().history().undoName(), "move flange east");
  ASSERT_TRUE(settle());
  EXPECT_LE(editor().deformation()->report.solve.maxResidualRelative, 1e-12);

  trigger("undo");
  EXPECT_EQ(editor().history().state(), state) << "one edit, however many keys";
}

TEST_F(NumberTypedAtAPoint, WhatIsTypedDuringADragCountsInsteadOfTheCursor)
{
  const Vector3 before = target();
  const QPointF from = onArrow(0);
  test::pressMouse(viewport(), from);
  test::moveMouse(viewport(), from + QPointF(40, 0), Qt::LeftButton);
  const Vector3 dragged = target();
  ASSERT_NE(dragged, before);
  keys("3-");
  test::moveMouse(viewport(), from + QPointF(40, 0), Qt::LeftButton);
  EXPECT_EQ(target(), Vector3(before - Vector3(3, 0, 0)));
  for (int k = 0; k < 2; ++k) key(Qt::Key_Backspace);
  EXPECT_EQ(target(), dragged) << "without a number the cursor counts again";
  keys("7");
  test::releaseMouse(viewport(), from + QPointF(60, 0));
  EXPECT_EQ(target(), Vector3(before + Vector3(7, 0, 0)));
  EXPECT_FALSE(editor().history().isInGesture());
}

TEST_F(NumberTypedAtAPoint, ATypedLengthIsTakenBackByEscapeAndByBackspace)
{
  const auto state = editor().history().state();
  const Positions positions = editor().positions();
  test::moveMouse(viewport(), onArrow(2));
  for (const Qt::Key back : {Qt::Key_Escape, Qt::Key_Backspace}) {
    keys("4");
    ASSERT_NE(editor().history().state(), state);
    ASSERT_TRUE(settle());
    key(back);
    EXPECT_EQ(editor().history().state(), state);
    EXPECT_EQ(editor().positions(), positions);
    EXPECT_FALSE(editor().history().isInGesture());
  }
}

TEST_F(NumberTypedAtAPoint, ATypedLengthIsKeptByAClickAndWhenTheKeyboardGoesElsewhere)
{
  const double before = target().z();
  test::moveMouse(viewport(), onArrow(2));
  keys("4");
  test::click(viewport(), {5, 5});
  EXPECT_EQ(target().z(), before + 4);
  EXPECT_FALSE(editor().history().isInGesture());
  EXPECT_EQ(editor().selectedConstraints(), std::vector<Index>{point}) << "the click did nothing else";

  viewport().setFocus();
  test::moveMouse(viewport(), onArrow(2));
  keys("2");
  ASSERT_TRUE(editor().history().isInGesture());
  table().setFocus();
  EXPECT_EQ(target().z(), before + 4 + 2);
  EXPECT_FALSE(editor().history().isInGesture());
}

TEST_F(NumberTypedAtAPoint, WhileALengthIsTypedNoOtherKeyEdits)
{
  test::moveMouse(viewport(), onArrow(2));
  keys("4");
  const std::size_t count = list().constraints.size();
  key(Qt::Key_Delete);
  keys("x");
  EXPECT_EQ(list().constraints.size(), count);
  EXPECT_TRUE(editor().history().isInGesture());
  key(Qt::Key_Enter);
  key(Qt::Key_Delete);
  EXPECT_EQ(list().constraints.size(), count - 1) << "the control: it deletes afterwards";
}

TEST_F(NumberTypedAtAHandle, ATypedAngleTurnsByExactlyThat)
{
  const auto rotation = [this] {
    const auto& turn = std::get<AxisRotation>(handle().motion);
    return Eigen::AngleAxisd(turn.degrees * std::numbers::pi / 180, turn.axis.normalized()).toRotationMatrix();
  };
  const Eigen::Matrix3d before = rotation();
  test::moveMouse(viewport(), seenAt(window.gizmo().gizmo().GetFrame().center) + QPointF(kGizmoPixels, 0));
  ASSERT_EQ(window.gizmo().gizmo().GetPart(), GizmoPart::ViewRing);
  keys("37.5");
  key(Qt::Key_Return);
  const Eigen::AngleAxisd rotated(Eigen::Matrix3d(rotation() * before.transpose()));
  EXPECT_NEAR(rotated.angle() * 180 / std::numbers::pi, 37.5, 1e-9);
  EXPECT_EQ(editor().history().undoName().substr(0, 6), "rotate");
}

TEST_F(NumberTypedAtAPoint, TwoPointsRotateAsAGroup)
{
  const Index other = *indexOf(list(), "flange west");
  const auto place = [this](Index row) {
    return std::get<Target>(std::get<PointConstraint>(list().constraints[row].what).to).place;
  };
  const Vector3 first = place(point);
  const Vector3 second = place(other);
  editor().selectConstraints({point, other});
  ASSERT_TRUE(settle());
  test::moveMouse(viewport(), seenAt(window.gizmo().gizmo().GetFrame().center) + QPointF(kGizmoPixels, 0));
  ASSERT_EQ(window.gizmo().gizmo().GetPart(), GizmoPart::ViewRing);
  keys("180");
  key(Qt::Key_Return);
  EXPECT_NEAR((place(point) - place(other)).norm(), (first - second).norm(), 1e-12);
  EXPECT_LT((place(point) + place(other) - first - second).norm(), 1e-12);
  EXPECT_GT((place(point) - first).norm(), 1);
  trigger("undo");
  EXPECT_EQ(place(other), second);
}

}  // namespace
}  // namespace holdfast
