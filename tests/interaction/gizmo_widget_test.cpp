#include "holdfast/view/interaction/gizmo_widget.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <numbers>
#include <sstream>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <vtkHandleWidget.h>
#include <vtkInteractorEventRecorder.h>
#include <vtkPointHandleRepresentation3D.h>
#include <vtkRenderWindow.h>
#include <vtkRendererCollection.h>
#include <vtkWidgetEvent.h>
#include <vtkWidgetEventTranslator.h>

#include <holdfast/view/interaction/interaction_events.h>
#include <holdfast/view/interaction/surface_camera_style.h>

#include "interaction/gizmo_stage.h"
#include "support/temporary_folder.h"

namespace holdfast {
namespace {

using test::EventLog;
using test::GizmoStage;
using test::Hand;
using test::placeOnArrow;
using test::placeOnGizmo;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

struct GizmoHandled : testing::Test {
  GizmoStage stage;
  vtkNew<GizmoWidget> widget;
  GizmoRepresentation& gizmo = *widget->GetGizmoRepresentation();
  Hand& hand = stage.hand();
  DisplayPoint beside{5, 5};
  std::vector<GizmoPart> parts;
  std::vector<GizmoMotion> motions;
  std::function<void()> atMotion = [] {};
  EventLog log{*widget,
               {vtkCommand::StartInteractionEvent, vtkCommand::InteractionEvent, vtkCommand::EndInteractionEvent,
                CancelInteractionEvent}};

  GizmoHandled()
  {
    gizmo.SetPixelSize(test::kGizmoRadius);
    gizmo.SetFrame({1.5, 1, 0}, Eigen::Matrix3d::Identity());
    widget->SetInteractor(&stage.interactor());
    widget->On();
    widget->AddObserver(vtkCommand::HighlightEvent, this, &GizmoHandled::notePart);
    widget->AddObserver(vtkCommand::InteractionEvent, this, &GizmoHandled::noteMotion);
  }

  void notePart(vtkObject*, unsigned long, void* part) { parts.push_back(*static_cast<GizmoPart*>(part)); }
  void noteMotion(vtkObject*, unsigned long, void* motion)
  {
    motions.push_back(*static_cast<GizmoMotion*>(motion));
    atMotion();
  }

  void standElsewhere() { gizmo.SetFrame({8, 8, 8}, Eigen::Matrix3d::Identity()); }

  [[nodiscard]] unsigned long lastEvent() const { return log.events().empty() ? 0 : log.events().back(); }
  [[nodiscard]] DisplayPoint arrow(int axis) const { return placeOnArrow(gizmo, axis); }
  [[nodiscard]] const Vector3& center() const { return gizmo.GetFrame().center; }

  /// Presses an arrow and moves on, along it on the display.
  void grabArrow(int axis, double pixels = 40)
  {
    const DisplayPoint from = arrow(axis);
    const DisplayPoint along = (from - placeOnGizmo(gizmo, Vector3::Zero())).normalized();
    hand.moveTo(from);
    hand.press(from);
    hand.moveTo(from + pixels * along);
  }
};

TEST_F(GizmoHandled, HighlightsThePartUnderTheCursor)
{
  hand.moveTo(arrow(0));
  hand.moveTo(arrow(0) + DisplayPoint(1, 0));
  EXPECT_EQ(widget->GetPart(), GizmoPart::ArrowX);
  hand.moveTo(arrow(2));
  hand.moveTo(beside);
  hand.moveTo(arrow(1));
  hand.leave();
  EXPECT_THAT(parts,
              ElementsAre(GizmoPart::ArrowX, GizmoPart::ArrowZ, GizmoPart::None, GizmoPart::ArrowY, GizmoPart::None));
  EXPECT_THAT(log.events(), IsEmpty());
}

TEST_F(GizmoHandled, ADragStartsMovesAndEnds)
{
  const Vector3 before = center();
  grabArrow(0);
  EXPECT_TRUE(widget->IsDragging());
  EXPECT_TRUE(widget->IsHeld());
  EXPECT_GT(motions.back().distance, 0.1);
  EXPECT_EQ(motions.back().translation, Vector3(motions.back().distance, 0, 0));
  hand.release(beside + DisplayPoint(100, 0));
  EXPECT_THAT(log.events(), ElementsAre(vtkCommand::StartInteractionEvent, vtkCommand::InteractionEvent,
                                        vtkCommand::InteractionEvent, vtkCommand::EndInteractionEvent));
  EXPECT_FALSE(widget->IsDragging());
  EXPECT_EQ(center(), Vector3(before + motions.back().translation));
}

TEST_F(GizmoHandled, WhatIsHeldStaysUnderTheCursorInBothProjections)
{
  for (const bool isParallel : {false, true}) {
    stage.renderer().GetActiveCamera()->SetParallelProjection(isParallel);
    for (int axis = 0; axis < 3; ++axis) {
      const ViewGeometry view = viewGeometryOf(stage.renderer());
      const Vector3 held =
          center() + placementOf(view, gizmo.GetFrame(), test::kGizmoRadius).scale * 0.5 * Vector3::Unit(axis);
      grabArrow(axis);
      const int* cursor = stage.interactor().GetEventPosition();
      const DisplayPoint now = *toDisplay(view, held + motions.back().translation);
      EXPECT_LT((now - DisplayPoint(cursor[0] + 0.5, cursor[1] + 0.5)).norm(), 1.5) << axis << isParallel;
      EXPECT_GT(motions.back().distance, 0.1);
      hand.key("Escape");
      hand.release(beside);
    }
  }
}

TEST_F(GizmoHandled, ThreeTurnsOfARingAre1080Degrees)
{
  const auto onRing = [&](double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    return placeOnGizmo(gizmo, gizmo_layout::kRingRadius * Vector3(std::cos(angle), std::sin(angle), 0));
  };
  hand.moveTo(onRing(20));
  ASSERT_EQ(widget->GetPart(), GizmoPart::RingZ);
  hand.press(onRing(20));
  for (int step = 1; step <= 3 * 12; ++step) hand.moveTo(onRing(20 + 30 * step));
  hand.release(onRing(20));
  EXPECT_NEAR(motions.back().degrees, 1080, 1e-9);
  EXPECT_EQ(motions.back().translation, Vector3::Zero());
  EXPECT_EQ(gizmo.GetFrame().axes, Eigen::Matrix3d::Identity());
}

TEST_F(GizmoHandled, ControlSnapsToExactMultiples)
{
  for (const bool isSnapped : {false, true}) {
    const DisplayPoint from = arrow(1);
    hand.moveTo(from);
    const RoundStep step = gizmo.NewDrag(from).step();
    hand.press(from);
    hand.moveTo(from + DisplayPoint(53, 21), {isSnapped});
    const double count = std::round(motions.back().distance / step.size());
    EXPECT_NE(count, 0);
    EXPECT_EQ(motions.back().distance == step.multiple(count), isSnapped);
    hand.key("Escape");
    hand.release(from);
  }
}

TEST_F(GizmoHandled, ATypedLengthMovesByExactlyThat)
{
  gizmo.SetUnits("mm");
  hand.moveTo(arrow(0));
  hand.type("2.5");
  EXPECT_TRUE(widget->IsDragging());
  EXPECT_FALSE(widget->IsHeld());
  EXPECT_EQ(gizmo.GetLabel(), "2.5_ mm");
  hand.moveTo(beside);
  EXPECT_EQ(center(), Vector3(1.5 + 2.5, 1, 0)) << "the mouse says no more";
  hand.key("Return");
  EXPECT_EQ(motions.back().distance, 2.5);
  EXPECT_EQ(motions.back().translation, Vector3(2.5, 0, 0));
  EXPECT_EQ(center(), Vector3(1.5 + 2.5, 1, 0));
  EXPECT_EQ(lastEvent(), vtkCommand::EndInteractionEvent);
  EXPECT_EQ(std::count(log.events().begin(), log.events().end(), vtkCommand::StartInteractionEvent), 1);
}

TEST_F(GizmoHandled, WhatIsTypedDuringADragCountsInsteadOfTheCursor)
{
  grabArrow(0);
  const Vector3 dragged = center();
  hand.type("3-");
  hand.moveTo(beside);
  EXPECT_EQ(center(), Vector3(1.5 - 3, 1, 0));
  hand.moveTo(arrow(0));
  hand.key("BackSpace");
  hand.key("BackSpace");
  EXPECT_EQ(motions.back().translation.head<1>(), Vector3(center() - Vector3(1.5, 1, 0)).head<1>());
  EXPECT_NE(center(), Vector3(1.5 - 3, 1, 0)) << "the cursor counts again";
  EXPECT_EQ(center().y(), dragged.y());
  hand.type("7");
  hand.release(beside);
  EXPECT_EQ(center(), Vector3(1.5 + 7, 1, 0));
  EXPECT_FALSE(widget->IsDragging());
}

TEST_F(GizmoHandled, BackspaceAndEscapeTakeATypedLengthBack)
{
  for (const char* back : {"BackSpace", "Escape"}) {
    log.clear();
    hand.moveTo(arrow(2));
    hand.type("4");
    EXPECT_EQ(center(), Vector3(1.5, 1, 4));
    hand.key(back);
    EXPECT_EQ(center(), Vector3(1.5, 1, 0));
    EXPECT_THAT(log.events(),
                ElementsAre(vtkCommand::StartInteractionEvent, vtkCommand::InteractionEvent, CancelInteractionEvent));
    EXPECT_EQ(widget->GetPart(), GizmoPart::ArrowZ);
    hand.moveTo(beside);
  }
}

TEST_F(GizmoHandled, AClickAndTheProgramKeepATypedLength)
{
  hand.moveTo(arrow(2));
  hand.type("4");
  hand.click(beside);
  EXPECT_EQ(center(), Vector3(1.5, 1, 4));
  EXPECT_EQ(lastEvent(), vtkCommand::EndInteractionEvent);
  widget->SetPart(GizmoPart::ArrowX);
  hand.type("1");
  widget->Keep();
  EXPECT_EQ(center(), Vector3(2.5, 1, 4));
  EXPECT_FALSE(widget->IsDragging());
  widget->Keep();
  EXPECT_EQ(std::count(log.events().begin(), log.events().end(), vtkCommand::EndInteractionEvent), 2);
}

TEST_F(GizmoHandled, TheKeyboardAloneMovesAndTurns)
{
  hand.moveTo(beside);
  for (const char* key : {"x", "2", "period", "5", "Return"}) hand.key(key);
  EXPECT_EQ(center(), Vector3(1.5 + 2.5, 1, 0));
  EXPECT_EQ(widget->GetPart(), GizmoPart::ArrowX) << "for the next one";
  hand.key("Y", {false, true});
  EXPECT_EQ(widget->GetPart(), GizmoPart::RingY);
  hand.type("37.5");
  hand.key("Return");
  EXPECT_EQ(motions.back().degrees, 37.5);
  EXPECT_EQ(motions.back().axis, Vector3::UnitY());
  hand.key("Z");
  EXPECT_EQ(widget->GetPart(), GizmoPart::ArrowZ) << "capitals without Shift";
}

TEST_F(GizmoHandled, WhatIsChosenStaysUntilEscapeOrAnotherPart)
{
  hand.key("x");
  hand.moveTo(beside);
  hand.leave();
  EXPECT_EQ(widget->GetPart(), GizmoPart::ArrowX);
  hand.moveTo(arrow(0));
  hand.moveTo(beside);
  EXPECT_EQ(widget->GetPart(), GizmoPart::ArrowX);
  hand.moveTo(arrow(1));
  EXPECT_EQ(widget->GetPart(), GizmoPart::ArrowY);
  hand.moveTo(beside);
  EXPECT_EQ(widget->GetPart(), GizmoPart::None);
  hand.key("z");
  hand.type("1");
  hand.key("x");
  EXPECT_EQ(widget->GetPart(), GizmoPart::ArrowZ) << "not while a number is typed";
  hand.key("Escape");
  EXPECT_EQ(widget->GetPart(), GizmoPart::None);
  EXPECT_EQ(center(), Vector3(1.5, 1, 0));
}

TEST_F(GizmoHandled, TheProgramChooses)
{
  widget->SetPart(GizmoPart::SquareZ);
  EXPECT_THAT(parts, ElementsAre(GizmoPart::SquareZ));
  gizmo.SetMotions(GizmoMotions::Moves);
  widget->SetPart(GizmoPart::RingX);
  hand.key("X", {false, true});
  EXPECT_EQ(widget->GetPart(), GizmoPart::SquareZ) << "what turns is not offered";
  widget->SetPart(GizmoPart::None);
  EXPECT_EQ(widget->GetPart(), GizmoPart::None);
  widget->Off();
  widget->SetPart(GizmoPart::ArrowX);
  EXPECT_EQ(widget->GetPart(), GizmoPart::None);
}

/// Of which sums and differences do not bring all bits back.
GizmoFrame awkwardFrame()
{
  return {{-0.0, 1e-310, 1.0 / 3}, Eigen::AngleAxisd(0.7, Vector3(1, 2, 3).normalized()).toRotationMatrix()};
}

bool hasBitsOf(const GizmoFrame& a, const GizmoFrame& b)
{
  return std::memcmp(a.center.data(), b.center.data(), sizeof(double) * 3) == 0 &&
         std::memcmp(a.axes.data(), b.axes.data(), sizeof(double) * 9) == 0;
}

TEST_F(GizmoHandled, EscapeBringsTheFrameBackBitForBit)
{
  gizmo.SetFrame(awkwardFrame().center, awkwardFrame().axes);
  const DisplayPoint middle = placeOnGizmo(gizmo, Vector3::Zero());
  hand.moveTo(middle);
  hand.press(middle);
  hand.moveTo(middle + DisplayPoint(31, 17));
  ASSERT_FALSE(hasBitsOf(gizmo.GetFrame(), awkwardFrame()));
  hand.key("Escape");
  EXPECT_TRUE(hasBitsOf(gizmo.GetFrame(), awkwardFrame()));
  EXPECT_EQ(lastEvent(), CancelInteractionEvent);
  log.clear();
  hand.moveTo(middle + DisplayPoint(60, 17));
  hand.release(middle + DisplayPoint(60, 17));
  EXPECT_TRUE(hasBitsOf(gizmo.GetFrame(), awkwardFrame())) << "the rest of the gesture says nothing";
  EXPECT_THAT(log.events(), IsEmpty());
}

TEST_F(GizmoHandled, DisablingCancelsADragAndTakesTheGizmoAway)
{
  const DisplayPoint place = arrow(0);
  grabArrow(0);
  widget->Off();
  EXPECT_EQ(lastEvent(), CancelInteractionEvent);
  EXPECT_EQ(center(), Vector3(1.5, 1, 0));
  EXPECT_EQ(widget->GetPart(), GizmoPart::None);
  EXPECT_EQ(stage.window().GetRenderers()->GetNumberOfItems(), 1);
  const std::size_t count = log.events().size();
  hand.click(place);
  hand.key("x");
  EXPECT_EQ(log.events().size(), count);
  EXPECT_EQ(widget->GetPart(), GizmoPart::None);

  stage.interactor().SetEventPosition(200, 150);
  widget->On();
  EXPECT_EQ(stage.window().GetRenderers()->GetNumberOfItems(), 2);
  grabArrow(0);
  EXPECT_TRUE(widget->IsDragging());
}

TEST_F(GizmoHandled, AProgramMayDisableItFromAnyEvent)
{
  for (const unsigned long event : {vtkCommand::HighlightEvent, vtkCommand::StartInteractionEvent,
                                    vtkCommand::InteractionEvent, vtkCommand::EndInteractionEvent}) {
    const unsigned long tag = widget->AddObserver(event, widget.Get(), &GizmoWidget::Off);
    const DisplayPoint place = arrow(0);
    hand.press(place);
    hand.moveTo(place + DisplayPoint(9, 9));
    hand.type("1");
    hand.release(beside);
    EXPECT_FALSE(widget->IsDragging());
    EXPECT_FALSE(widget->GetEnabled());
    widget->RemoveObserver(tag);
    stage.interactor().SetEventPosition(200, 150);
    gizmo.SetFrame({1.5, 1, 0}, Eigen::Matrix3d::Identity());
    widget->On();
    gizmo.VisibilityOn();
    const unsigned long hider = widget->AddObserver(event, &gizmo, &GizmoRepresentation::VisibilityOff);
    grabArrow(0);
    hand.release(beside);
    EXPECT_FALSE(widget->IsDragging());
    gizmo.VisibilityOn();
    hand.moveTo(beside);
    hand.press(arrow(2));
    hand.release(beside);
    EXPECT_FALSE(widget->IsDragging());
    widget->RemoveObserver(hider);
    gizmo.SetFrame({1.5, 1, 0}, Eigen::Matrix3d::Identity());
    gizmo.VisibilityOn();
  }
}

TEST_F(GizmoHandled, GoesWithItsWindow)
{
  vtkNew<GizmoWidget> other;
  {
    GizmoStage gone;
    other->SetInteractor(&gone.interactor());
    other->On();
    gone.window().Render();
  }
  EXPECT_FALSE(other->GetEnabled());
  {
    GizmoStage left;
    {
      vtkNew<GizmoWidget> gone;
      gone->SetInteractor(&left.interactor());
      gone->On();
    }
    EXPECT_FALSE(left.interactor().HasObserver(vtkCommand::MiddleButtonPressEvent));
  }
  {
    vtkNew<GizmoWidget> deleted;
    deleted->SetInteractor(&stage.interactor());
    deleted->On();
    ASSERT_EQ(stage.window().GetRenderers()->GetNumberOfItems(), 3);
  }
  EXPECT_EQ(stage.window().GetRenderers()->GetNumberOfItems(), 2);
  EXPECT_EQ(stage.renderer().GetViewProps()->GetNumberOfItems(), 2) << "the surface, and the first gizmo";
  stage.window().Render();
  hand.moveTo(arrow(0));
  EXPECT_EQ(widget->GetPart(), GizmoPart::ArrowX);
}

TEST_F(GizmoHandled, ActsInItsOwnRendererAlone)
{
  stage.renderer().SetViewport(0, 0, 0.5, 1);
  vtkNew<vtkRenderer> right;
  right->SetViewport(0.5, 0, 1, 1);
  right->SetActiveCamera(stage.renderer().GetActiveCamera());
  stage.window().AddRenderer(right);
  vtkNew<GizmoWidget> other;
  other->SetInteractor(&stage.interactor());
  other->SetCurrentRenderer(right);
  GizmoRepresentation& otherGizmo = *other->GetGizmoRepresentation();
  otherGizmo.SetPixelSize(test::kGizmoRadius);
  otherGizmo.SetFrame({1.5, 1, 0}, Eigen::Matrix3d::Identity());
  other->On();

  gizmo.SetPixelSize(120);
  const DisplayPoint own = placeOnGizmo(gizmo, Vector3::Zero());
  hand.moveTo(own + 120 * DisplayPoint(-0.6, 0.8));
  EXPECT_EQ(widget->GetPart(), GizmoPart::ViewRing);
  hand.moveTo(own + DisplayPoint(120, 0));
  EXPECT_EQ(widget->GetPart(), GizmoPart::None) << "its rings end at the edge of its viewport";
  const DisplayPoint middle = placeOnGizmo(otherGizmo, Vector3::Zero());
  hand.moveTo(middle);
  EXPECT_EQ(other->GetPart(), GizmoPart::Center);
  hand.moveTo(arrow(0));
  EXPECT_EQ(widget->GetPart(), GizmoPart::ArrowX);
  EXPECT_EQ(other->GetPart(), GizmoPart::None);
  hand.drag({middle, middle + DisplayPoint(10, 10), middle + DisplayPoint(30, 20)});
  EXPECT_NE(otherGizmo.GetFrame().center, Vector3(1.5, 1, 0));
  EXPECT_EQ(center(), Vector3(1.5, 1, 0));
}

TEST_F(GizmoHandled, CamerasGetWhatTheGizmoDoesNotUse)
{
  vtkNew<SurfaceCameraStyle> style;
  stage.interactor().SetInteractorStyle(style);
  vtkCamera& camera = *stage.renderer().GetActiveCamera();
  const Vector3 eye(camera.GetPosition());
  hand.drag({arrow(0), arrow(0) + DisplayPoint(20, 0), arrow(0) + DisplayPoint(40, 10)});
  EXPECT_EQ(Vector3(camera.GetPosition()), eye);
  ASSERT_NE(center(), Vector3(1.5, 1, 0));
  hand.drag({beside, beside + DisplayPoint(20, 20), beside + DisplayPoint(40, 40)});
  EXPECT_NE(Vector3(camera.GetPosition()), eye);
  stage.interactor().SetInteractorStyle(nullptr);
}

TEST_F(GizmoHandled, StaysOutOfGesturesThatBeganBesideIt)
{
  EventLog moves(stage.interactor(), {vtkCommand::MouseMoveEvent});
  hand.moveTo(beside);
  hand.press(beside);
  hand.moveTo(arrow(0));
  EXPECT_EQ(widget->GetPart(), GizmoPart::None);
  hand.release(arrow(0));
  hand.rightPress(beside);
  hand.moveTo(arrow(1));
  hand.moveTo(arrow(1) + DisplayPoint(1, 0));
  EXPECT_EQ(widget->GetPart(), GizmoPart::None);
  EXPECT_EQ(moves.events().size(), 4u) << "all passed on";
  hand.rightRelease(arrow(1));
  moves.clear();
  hand.moveTo(arrow(1));
  EXPECT_EQ(widget->GetPart(), GizmoPart::ArrowY);
  EXPECT_EQ(moves.events().size(), 1u) << "others learn that the cursor has left what is theirs";
  hand.moveTo(arrow(1) + DisplayPoint(1, 0));
  EXPECT_EQ(moves.events().size(), 1u);

  vtkNew<vtkCallbackCommand> brush;
  brush->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  brush->AbortFlagOnExecuteOn();
  stage.interactor().AddObserver(vtkCommand::LeftButtonPressEvent, brush, 0.5F);
  hand.moveTo(beside);
  hand.press(beside);
  hand.moveTo(arrow(0));
  EXPECT_EQ(widget->GetPart(), GizmoPart::None) << "a press that another widget has used";
}

TEST_F(GizmoHandled, ComesBeforeVtksOwnWidgetsAndLeavesThemTheRest)
{
  vtkNew<vtkPointHandleRepresentation3D> point;
  double place[] = {1.5, 1, 0};
  point->SetWorldPosition(place);
  vtkNew<vtkHandleWidget> handle;
  handle->SetRepresentation(point);
  handle->SetInteractor(&stage.interactor());
  handle->On();
  EventLog handled(*handle, {vtkCommand::StartInteractionEvent, vtkCommand::EndInteractionEvent});
  const DisplayPoint middle = placeOnGizmo(gizmo, Vector3::Zero());
  stage.window().Render();
  const auto dragMiddle = [&] { hand.drag({middle, middle + DisplayPoint(9, 0), middle + DisplayPoint(25, 0)}); };
  dragMiddle();
  EXPECT_EQ(lastEvent(), vtkCommand::EndInteractionEvent);
  EXPECT_THAT(handled.events(), IsEmpty());

  gizmo.SetFrame({3, 2, 0}, Eigen::Matrix3d::Identity());
  gizmo.SetPixelSize(20);
  log.clear();
  dragMiddle();
  EXPECT_THAT(handled.events(), ElementsAre(vtkCommand::StartInteractionEvent, vtkCommand::EndInteractionEvent));
  EXPECT_THAT(log.events(), IsEmpty());
  hand.moveTo(placeOnGizmo(gizmo, Vector3::Zero()));
  EXPECT_EQ(widget->GetPart(), GizmoPart::Center) << "the release went to the handle alone";

  gizmo.SetFrame({1.5, 1, 0}, Eigen::Matrix3d::Identity());
  widget->SetPriority(0.4F);
  point->SetWorldPosition(place);
  handled.clear();
  dragMiddle();
  EXPECT_FALSE(handled.events().empty()) << "the control: a widget of higher priority";
}

TEST_F(GizmoHandled, ListensToOtherButtonsAndKeysIfToldSo)
{
  vtkWidgetEventTranslator& translator = *widget->GetEventTranslator();
  translator.RemoveTranslation(vtkCommand::LeftButtonPressEvent);
  translator.SetTranslation(vtkCommand::MiddleButtonPressEvent, vtkWidgetEvent::Select);
  translator.SetTranslation(vtkCommand::MiddleButtonReleaseEvent, vtkWidgetEvent::EndSelect);
  translator.SetTranslation(vtkCommand::KeyPressEvent, 0, 'k', 0, nullptr, vtkWidgetEvent::Completed);
  widget->Off();
  stage.interactor().SetEventPosition(200, 150);
  widget->On();
  hand.moveTo(arrow(0));
  hand.press(arrow(0));
  EXPECT_FALSE(widget->IsDragging());
  hand.release(arrow(0));
  hand.middlePress(arrow(0));
  EXPECT_TRUE(widget->IsDragging());
  hand.middleRelease(arrow(0) + DisplayPoint(20, 0));
  EXPECT_EQ(lastEvent(), vtkCommand::EndInteractionEvent);
  hand.key("x");
  hand.type("4");
  ASSERT_TRUE(widget->IsDragging());
  hand.key("k");
  EXPECT_FALSE(widget->IsDragging());
}

TEST_F(GizmoHandled, GrabsWithTheSecondPressOfADoubleClick)
{
  hand.doubleClick(arrow(0));
  const auto started = [this] {
    return std::count(log.events().begin(), log.events().end(), vtkCommand::StartInteractionEvent);
  };
  EXPECT_EQ(started(), 2);
  hand.moveTo(arrow(0));
  stage.interactor().InvokeEvent(vtkCommand::LeftButtonDoubleClickEvent);
  EXPECT_EQ(started(), 3);
  EXPECT_TRUE(widget->IsHeld());
}

TEST_F(GizmoHandled, KeysThatItUsesReachNobodyElse)
{
  EventLog keys(stage.interactor(), {vtkCommand::KeyPressEvent, vtkCommand::CharEvent});
  hand.key("3");
  EXPECT_EQ(keys.events().size(), 2u) << "over nothing";
  keys.clear();
  hand.moveTo(arrow(0));
  for (const char* key : {"3", "BackSpace", "4", "Escape"}) hand.key(key);
  EXPECT_THAT(keys.events(), ElementsAre(vtkCommand::CharEvent, vtkCommand::CharEvent))
      << "characters after the end of a number: styles do nothing with those";
  keys.clear();
  hand.moveTo(arrow(0));
  hand.key("3", {true});
  hand.key("x", {true});
  hand.key("3", {false, false, true});
  EXPECT_EQ(keys.events().size(), 6u) << "shortcuts";
  EXPECT_FALSE(widget->IsDragging());
  EXPECT_EQ(widget->GetPart(), GizmoPart::ArrowX);
}

TEST_F(GizmoHandled, SaysWhichKeysItWants)
{
  constexpr char kEscape = 27;
  EXPECT_TRUE(widget->WantsKey('x'));
  for (const char key : {'3', '-', 'w', '\r', '\b', kEscape}) EXPECT_FALSE(widget->WantsKey(key)) << int{key};
  hand.moveTo(arrow(0));
  EXPECT_TRUE(widget->WantsKey('3'));
  EXPECT_FALSE(widget->WantsKey(kEscape));
  hand.key("x");
  EXPECT_TRUE(widget->WantsKey(kEscape));
  hand.type("3");
  for (const char key : {'3', 'w', 'x', '\r', '\b', kEscape}) EXPECT_TRUE(widget->WantsKey(key)) << int{key};
  hand.key("Return");
  EXPECT_FALSE(widget->WantsKey('\r'));
  gizmo.VisibilityOff();
  for (const char key : {'3', 'x', kEscape}) EXPECT_FALSE(widget->WantsKey(key)) << int{key};
  gizmo.VisibilityOn();
  widget->Off();
  EXPECT_FALSE(widget->WantsKey('x'));
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
  hand.click(arrow(0));
  EXPECT_THAT(log.events(), IsEmpty());
  EXPECT_THAT(parts, IsEmpty());
}

TEST_F(GizmoHandled, ARecordedGestureGivesTheSameMotion)
{
  const test::TemporaryFolder folder;
  const std::string file = (folder.path() / "gesture.log").string();
  vtkNew<vtkInteractorEventRecorder> recorder;
  recorder->SetInteractor(&stage.interactor());
  recorder->SetFileName(file.c_str());
  recorder->On();
  recorder->Record();
  grabArrow(0, 37);
  hand.release(arrow(0) + DisplayPoint(11, 3));
  hand.key("y");
  hand.type("1.25");
  hand.key("Return");
  recorder->Stop();
  recorder->Off();
  const std::vector<GizmoMotion> byHand = motions;
  const auto events = log.events();
  const Vector3 after = center();
  ASSERT_GT(byHand.size(), 4u);

  hand.key("Escape");
  hand.moveTo(beside);
  gizmo.SetFrame({1.5, 1, 0}, Eigen::Matrix3d::Identity());
  motions.clear();
  log.clear();
  recorder->Play();
  ASSERT_EQ(motions.size(), byHand.size());
  for (std::size_t k = 0; k < motions.size(); ++k) EXPECT_EQ(motions[k].translation, byHand[k].translation) << k;
  EXPECT_EQ(log.events(), events);
  EXPECT_EQ(center(), after);
}

TEST_F(GizmoHandled, PrintsItsState)
{
  hand.key("y");
  hand.type("1.5");
  std::ostringstream text;
  widget->Print(text);
  EXPECT_THAT(text.str(), HasSubstr("Typed: 1.5"));
  EXPECT_THAT(text.str(), HasSubstr("Dragging: 1"));
}

}  // namespace
}  // namespace holdfast
