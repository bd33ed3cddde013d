#include <algorithm>

#include <gmock/gmock.h>

#include <holdfast/widgets/interaction/interaction_events.h>

#include "interaction/gizmo_handled.h"

namespace holdfast {
namespace {

using test::EventLog;
using test::GizmoHandled;
using testing::ElementsAre;

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

}  // namespace
}  // namespace holdfast
