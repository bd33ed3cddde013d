#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <vtkInteractorEventRecorder.h>

#include <holdfast/numbers/same_bits.h>
#include <holdfast/widgets/interaction/interaction_events.h>
#include <holdfast/widgets/interaction/vtkHoldfastSurfaceCameraStyle.h>

#include "interaction/gizmo_handled.h"
#include "support/temporary_folder.h"

namespace holdfast {
namespace {

using test::EventLog;
using test::GizmoHandled;
using test::placeOnGizmo;
using testing::ElementsAre;
using testing::IsEmpty;

TEST_F(GizmoHandled, ADragStartsMovesAndEnds)
{
  const Vector3 before = center();
  grabArrow(0);
  EXPECT_TRUE(widget->IsDragging());
  EXPECT_TRUE(widget->IsHeld());
  EXPECT_GT(motions.back().distance, 0.1);
  EXPECT_EQ(motions.back().translation, Vector3(motions.back().distance, 0, 0));
  mouse.release(beside + DisplayPoint(100, 0));
  EXPECT_THAT(log.events(), ElementsAre(vtkCommand::StartInteractionEvent, vtkCommand::InteractionEvent,
                                        vtkCommand::InteractionEvent, vtkCommand::EndInteractionEvent));
  EXPECT_FALSE(widget->IsDragging());
  EXPECT_EQ(center(), Vector3(before + motions.back().translation));
}

TEST_F(GizmoHandled, WhatIsHeldStaysUnderTheCursorInBothProjections)
{
  for (const bool isParallel : {false, true}) {
    fixture.renderer().GetActiveCamera()->SetParallelProjection(isParallel);
    for (int axis = 0; axis < 3; ++axis) {
      const DisplayTransform view(fixture.renderer());
      const Vector3 held =
          center() + placementOf(view, gizmo.GetFrame(), test::kGizmoRadius).scale * 0.5 * Vector3::Unit(axis);
      grabArrow(axis);
      const int* cursor = fixture.interactor().GetEventPosition();
      const DisplayPoint now = *toDisplay(view, held + motions.back().translation);
      EXPECT_LT((now - DisplayPoint(cursor[0] + 0.5, cursor[1] + 0.5)).norm(), 1.5) << axis << isParallel;
      EXPECT_GT(motions.back().distance, 0.1);
      mouse.key("Escape");
      mouse.release(beside);
    }
  }
}

TEST_F(GizmoHandled, ThreeTurnsOfARingAre1080Degrees)
{
  const auto onRing = [&](double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    return placeOnGizmo(gizmo, gizmo_layout::kRingRadius * Vector3(std::cos(angle), std::sin(angle), 0));
  };
  mouse.moveTo(onRing(20));
  ASSERT_EQ(widget->GetPart(), GizmoPart::RingZ);
  mouse.press(onRing(20));
  for (int step = 1; step <= 3 * 12; ++step) mouse.moveTo(onRing(20 + 30 * step));
  mouse.release(onRing(20));
  EXPECT_NEAR(motions.back().degrees, 1080, 1e-9);
  EXPECT_EQ(motions.back().translation, Vector3::Zero());
  EXPECT_EQ(gizmo.GetFrame().axes, Eigen::Matrix3d::Identity());
}

TEST_F(GizmoHandled, ControlSnapsToExactMultiples)
{
  for (const bool isSnapped : {false, true}) {
    const DisplayPoint from = arrow(1);
    mouse.moveTo(from);
    const RoundStep step = gizmo.NewDrag(from).step();
    mouse.press(from);
    mouse.moveTo(from + DisplayPoint(53, 21), {isSnapped});
    const double count = std::round(motions.back().distance / step.size());
    EXPECT_NE(count, 0);
    EXPECT_EQ(motions.back().distance == step.multiple(count), isSnapped);
    mouse.key("Escape");
    mouse.release(from);
  }
}

/// Of which sums and differences do not bring all bits back.
GizmoFrame awkwardFrame()
{
  return {{-0.0, 1e-310, 1.0 / 3}, Eigen::AngleAxisd(0.7, Vector3(1, 2, 3).normalized()).toRotationMatrix()};
}

bool hasBitsOf(const GizmoFrame& a, const GizmoFrame& b)
{
  bool isSame = true;
  for (Index k = 0; k < 3; ++k) isSame = isSame && hasSameBits(a.center[k], b.center[k]);
  for (Index k = 0; k < 9; ++k) isSame = isSame && hasSameBits(a.axes(k), b.axes(k));
  return isSame;
}

TEST_F(GizmoHandled, EscapeBringsTheFrameBackBitForBit)
{
  gizmo.SetFrame(awkwardFrame().center, awkwardFrame().axes);
  const DisplayPoint middle = placeOnGizmo(gizmo, Vector3::Zero());
  mouse.moveTo(middle);
  mouse.press(middle);
  mouse.moveTo(middle + DisplayPoint(31, 17));
  ASSERT_FALSE(hasBitsOf(gizmo.GetFrame(), awkwardFrame()));
  mouse.key("Escape");
  EXPECT_TRUE(hasBitsOf(gizmo.GetFrame(), awkwardFrame()));
  EXPECT_EQ(lastEvent(), CancelInteractionEvent);
  log.clear();
  mouse.moveTo(middle + DisplayPoint(60, 17));
  mouse.release(middle + DisplayPoint(60, 17));
  EXPECT_TRUE(hasBitsOf(gizmo.GetFrame(), awkwardFrame())) << "the rest of the gesture says nothing";
  EXPECT_THAT(log.events(), IsEmpty());
}

TEST_F(GizmoHandled, CamerasGetWhatTheGizmoDoesNotUse)
{
  vtkNew<vtkHoldfastSurfaceCameraStyle> style;
  fixture.interactor().SetInteractorStyle(style);
  vtkCamera& camera = *fixture.renderer().GetActiveCamera();
  const Vector3 eye(camera.GetPosition());
  mouse.drag({arrow(0), arrow(0) + DisplayPoint(20, 0), arrow(0) + DisplayPoint(40, 10)});
  EXPECT_EQ(Vector3(camera.GetPosition()), eye);
  ASSERT_NE(center(), Vector3(1.5, 1, 0));
  mouse.drag({beside, beside + DisplayPoint(20, 20), beside + DisplayPoint(40, 40)});
  EXPECT_NE(Vector3(camera.GetPosition()), eye);
  fixture.interactor().SetInteractorStyle(nullptr);
}

TEST_F(GizmoHandled, StaysOutOfGesturesThatBeganBesideIt)
{
  EventLog moves(fixture.interactor(), {vtkCommand::MouseMoveEvent});
  mouse.moveTo(beside);
  mouse.press(beside);
  mouse.moveTo(arrow(0));
  EXPECT_EQ(widget->GetPart(), GizmoPart::None);
  mouse.release(arrow(0));
  mouse.rightPress(beside);
  mouse.moveTo(arrow(1));
  mouse.moveTo(arrow(1) + DisplayPoint(1, 0));
  EXPECT_EQ(widget->GetPart(), GizmoPart::None);
  EXPECT_EQ(moves.events().size(), 4u) << "all passed on";
  mouse.rightRelease(arrow(1));
  moves.clear();
  mouse.moveTo(arrow(1));
  EXPECT_EQ(widget->GetPart(), GizmoPart::ArrowY);
  EXPECT_EQ(moves.events().size(), 1u) << "others learn that the cursor has left what is theirs";
  mouse.moveTo(arrow(1) + DisplayPoint(1, 0));
  EXPECT_EQ(moves.events().size(), 1u);

  vtkNew<vtkCallbackCommand> brush;
  brush->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  brush->AbortFlagOnExecuteOn();
  fixture.interactor().AddObserver(vtkCommand::LeftButtonPressEvent, brush, 0.5F);
  mouse.moveTo(beside);
  mouse.press(beside);
  mouse.moveTo(arrow(0));
  EXPECT_EQ(widget->GetPart(), GizmoPart::None) << "a press that another widget has used";
}

TEST_F(GizmoHandled, GrabsWithTheSecondPressOfADoubleClick)
{
  mouse.doubleClick(arrow(0));
  const auto started = [this] {
    return std::count(log.events().begin(), log.events().end(), vtkCommand::StartInteractionEvent);
  };
  EXPECT_EQ(started(), 2);
  mouse.moveTo(arrow(0));
  fixture.interactor().InvokeEvent(vtkCommand::LeftButtonDoubleClickEvent);
  EXPECT_EQ(started(), 3);
  EXPECT_TRUE(widget->IsHeld());
}

TEST_F(GizmoHandled, ADragAloneMovesTheGizmoWhileItGoesOn)
{
  atMotion = [this] { gizmo.SetFrame({9, 9, 9}, Eigen::Matrix3d::Identity()); };
  grabArrow(0);
  EXPECT_EQ(center(), Vector3(Vector3(1.5, 1, 0) + motions.back().translation));
  widget->AddObserver(CancelInteractionEvent, this, &GizmoHandled::standElsewhere);
  widget->Cancel();
  EXPECT_EQ(center(), Vector3(8, 8, 8)) << "at its end the program may move it";
}

TEST_F(GizmoHandled, TheMouseOverHiddenPartsIsNotItsOwn)
{
  gizmo.VisibilityOff();
  mouse.click(arrow(0));
  EXPECT_THAT(log.events(), IsEmpty());
  EXPECT_THAT(parts, IsEmpty());
}

TEST_F(GizmoHandled, ARecordedGestureGivesTheSameMotion)
{
  const test::TemporaryFolder folder;
  const std::string file = (folder.path() / "gesture.log").string();
  vtkNew<vtkInteractorEventRecorder> recorder;
  recorder->SetInteractor(&fixture.interactor());
  recorder->SetFileName(file.c_str());
  recorder->On();
  recorder->Record();
  grabArrow(0, 37);
  mouse.release(arrow(0) + DisplayPoint(11, 3));
  mouse.key("y");
  mouse.type("1.25");
  mouse.key("Return");
  recorder->Stop();
  recorder->Off();
  const std::vector<GizmoMotion> byHand = motions;
  const auto events = log.events();
  const Vector3 after = center();
  ASSERT_GT(byHand.size(), 4u);

  mouse.key("Escape");
  mouse.moveTo(beside);
  gizmo.SetFrame({1.5, 1, 0}, Eigen::Matrix3d::Identity());
  motions.clear();
  log.clear();
  recorder->Play();
  ASSERT_EQ(motions.size(), byHand.size());
  for (std::size_t k = 0; k < motions.size(); ++k) EXPECT_EQ(motions[k].translation, byHand[k].translation) << k;
  EXPECT_EQ(log.events(), events);
  EXPECT_EQ(center(), after);
}

}  // namespace
}  // namespace holdfast
