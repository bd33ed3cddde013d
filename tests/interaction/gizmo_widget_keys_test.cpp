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
  mouse.moveTo(arrow(0));
  mouse.type("2.5");
  EXPECT_TRUE(widget->IsDragging());
  EXPECT_FALSE(widget->IsHeld());
  EXPECT_EQ(gizmo.GetLabel(), "2.5_ mm");
  mouse.moveTo(beside);
  EXPECT_EQ(center(), Vector3(1.5 + 2.5, 1, 0)) << "the mouse says no more";
  mouse.key("Return");
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
  mouse.type("3-");
  mouse.moveTo(beside);
  EXPECT_EQ(center(), Vector3(1.5 - 3, 1, 0));
  mouse.moveTo(arrow(0));
  mouse.key("BackSpace");
  mouse.key("BackSpace");
  EXPECT_EQ(motions.back().translation.head<1>(), Vector3(center() - Vector3(1.5, 1, 0)).head<1>());
  EXPECT_NE(center(), Vector3(1.5 - 3, 1, 0)) << "the cursor counts again";
  EXPECT_EQ(center().y(), dragged.y());
  mouse.type("7");
  mouse.release(beside);
  EXPECT_EQ(center(), Vector3(1.5 + 7, 1, 0));
  EXPECT_FALSE(widget->IsDragging());
}

TEST_F(GizmoHandled, BackspaceAndEscapeTakeATypedLengthBack)
{
  for (const char* back : {"BackSpace", "Escape"}) {
    log.clear();
    mouse.moveTo(arrow(2));
    mouse.type("4");
    EXPECT_EQ(center(), Vector3(1.5, 1, 4));
    mouse.key(back);
    EXPECT_EQ(center(), Vector3(1.5, 1, 0));
    EXPECT_THAT(log.events(),
                ElementsAre(vtkCommand::StartInteractionEvent, vtkCommand::InteractionEvent, CancelInteractionEvent));
    EXPECT_EQ(widget->GetPart(), GizmoPart::ArrowZ);
    mouse.moveTo(beside);
  }
}

TEST_F(GizmoHandled, AClickAndTheProgramKeepATypedLength)
{
  mouse.moveTo(arrow(2));
  mouse.type("4");
  mouse.click(beside);
  EXPECT_EQ(center(), Vector3(1.5, 1, 4));
  EXPECT_EQ(lastEvent(), vtkCommand::EndInteractionEvent);
  widget->SetPart(GizmoPart::ArrowX);
  mouse.type("1");
  widget->Keep();
  EXPECT_EQ(center(), Vector3(2.5, 1, 4));
  EXPECT_FALSE(widget->IsDragging());
  widget->Keep();
  EXPECT_EQ(std::count(log.events().begin(), log.events().end(), vtkCommand::EndInteractionEvent), 2);
}

TEST_F(GizmoHandled, TheKeyboardAloneMovesAndTurns)
{
  mouse.moveTo(beside);
  for (const char* key : {"x", "2", "period", "5", "Return"}) mouse.key(key);
  EXPECT_EQ(center(), Vector3(1.5 + 2.5, 1, 0));
  EXPECT_EQ(widget->GetPart(), GizmoPart::ArrowX) << "for the next one";
  mouse.key("Y", {false, true});
  EXPECT_EQ(widget->GetPart(), GizmoPart::RingY);
  mouse.type("37.5");
  mouse.key("Return");
  EXPECT_EQ(motions.back().degrees, 37.5);
  EXPECT_EQ(motions.back().axis, Vector3::UnitY());
  mouse.key("Z");
  EXPECT_EQ(widget->GetPart(), GizmoPart::ArrowZ) << "capitals without Shift";
}

TEST_F(GizmoHandled, WhatIsChosenStaysUntilEscapeOrAnotherPart)
{
  mouse.key("x");
  mouse.moveTo(beside);
  mouse.leave();
  EXPECT_EQ(widget->GetPart(), GizmoPart::ArrowX);
  mouse.moveTo(arrow(0));
  mouse.moveTo(beside);
  EXPECT_EQ(widget->GetPart(), GizmoPart::ArrowX);
  mouse.moveTo(arrow(1));
  EXPECT_EQ(widget->GetPart(), GizmoPart::ArrowY);
  mouse.moveTo(beside);
  EXPECT_EQ(widget->GetPart(), GizmoPart::None);
  mouse.key("z");
  mouse.type("1");
  mouse.key("x");
  EXPECT_EQ(widget->GetPart(), GizmoPart::ArrowZ) << "not while a number is typed";
  mouse.key("Escape");
  EXPECT_EQ(widget->GetPart(), GizmoPart::None);
  EXPECT_EQ(center(), Vector3(1.5, 1, 0));
}

TEST_F(GizmoHandled, KeysThatItUsesReachNobodyElse)
{
  EventLog keys(fixture.interactor(), {vtkCommand::KeyPressEvent, vtkCommand::CharEvent});
  mouse.key("3");
  EXPECT_EQ(keys.events().size(), 2u) << "over nothing";
  keys.clear();
  mouse.moveTo(arrow(0));
  for (const char* key : {"3", "BackSpace", "4", "Escape"}) mouse.key(key);
  EXPECT_THAT(keys.events(), ElementsAre(vtkCommand::CharEvent, vtkCommand::CharEvent))
      << "characters after the end of a number: styles do nothing with those";
  keys.clear();
  mouse.moveTo(arrow(0));
  mouse.key("3", {true});
  mouse.key("x", {true});
  mouse.key("3", {false, false, true});
  EXPECT_EQ(keys.events().size(), 6u) << "shortcuts";
  EXPECT_FALSE(widget->IsDragging());
  EXPECT_EQ(widget->GetPart(), GizmoPart::ArrowX);
}

TEST_F(GizmoHandled, SaysWhichKeysItWants)
{
  constexpr char kEscape = 27;
  EXPECT_TRUE(widget->WantsKey('x'));
  for (const char key : {'3', '-', 'w', '\r', '\b', kEscape}) EXPECT_FALSE(widget->WantsKey(key)) << int{key};
  mouse.moveTo(arrow(0));
  EXPECT_TRUE(widget->WantsKey('3'));
  EXPECT_FALSE(widget->WantsKey(kEscape));
  mouse.key("x");
  EXPECT_TRUE(widget->WantsKey(kEscape));
  mouse.type("3");
  for (const char key : {'3', 'w', 'x', '\r', '\b', kEscape}) EXPECT_TRUE(widget->WantsKey(key)) << int{key};
  mouse.key("Return");
  EXPECT_FALSE(widget->WantsKey('\r'));
  gizmo.VisibilityOff();
  for (const char key : {'3', 'x', kEscape}) EXPECT_FALSE(widget->WantsKey(key)) << int{key};
  gizmo.VisibilityOn();
  widget->Off();
  EXPECT_FALSE(widget->WantsKey('x'));
}

}  // namespace
}  // namespace holdfast
