#include <sstream>

#include <gmock/gmock.h>
#include <vtkHandleWidget.h>
#include <vtkPointHandleRepresentation3D.h>
#include <vtkRenderWindow.h>
#include <vtkRendererCollection.h>
#include <vtkWidgetEvent.h>
#include <vtkWidgetEventTranslator.h>

#include <holdfast/widgets/interaction/interaction_events.h>
#include <holdfast/widgets/interaction/vtkHoldfastGizmoRepresentation.h>

#include "holdfast/widgets/interaction/vtkHoldfastGizmoWidget.h"
#include "interaction/gizmo_handled.h"

namespace holdfast {
namespace {

using test::EventLog;
using test::GizmoFixture;
using test::GizmoHandled;
using test::placeOnGizmo;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST_F(GizmoHandled, HighlightsThePartUnderTheCursor)
{
  mouse.moveTo(arrow(0));
  mouse.moveTo(arrow(0) + DisplayPoint(1, 0));
  EXPECT_EQ(widget->GetPart(), GizmoPart::ArrowX);
  mouse.moveTo(arrow(2));
  mouse.moveTo(beside);
  mouse.moveTo(arrow(1));
  mouse.leave();
  EXPECT_THAT(parts,
              ElementsAre(GizmoPart::ArrowX, GizmoPart::ArrowZ, GizmoPart::None, GizmoPart::ArrowY, GizmoPart::None));
  EXPECT_THAT(log.events(), IsEmpty());
}

TEST_F(GizmoHandled, TheProgramChooses)
{
  widget->SetPart(GizmoPart::SquareZ);
  EXPECT_THAT(parts, ElementsAre(GizmoPart::SquareZ));
  gizmo.SetMotions(GizmoMotions::Moves);
  widget->SetPart(GizmoPart::RingX);
  mouse.key("X", {false, true});
  EXPECT_EQ(widget->GetPart(), GizmoPart::SquareZ) << "what turns is not offered";
  widget->SetPart(GizmoPart::None);
  EXPECT_EQ(widget->GetPart(), GizmoPart::None);
  widget->Off();
  widget->SetPart(GizmoPart::ArrowX);
  EXPECT_EQ(widget->GetPart(), GizmoPart::None);
}

TEST_F(GizmoHandled, DisablingCancelsADragAndTakesTheGizmoAway)
{
  const DisplayPoint place = arrow(0);
  grabArrow(0);
  widget->Off();
  EXPECT_EQ(lastEvent(), CancelInteractionEvent);
  EXPECT_EQ(center(), Vector3(1.5, 1, 0));
  EXPECT_EQ(widget->GetPart(), GizmoPart::None);
  EXPECT_EQ(fixture.window().GetRenderers()->GetNumberOfItems(), 1);
  const std::size_t count = log.events().size();
  mouse.click(place);
  mouse.key("x");
  EXPECT_EQ(log.events().size(), count);
  EXPECT_EQ(widget->GetPart(), GizmoPart::None);

  fixture.interactor().SetEventPosition(200, 150);
  widget->On();
  EXPECT_EQ(fixture.window().GetRenderers()->GetNumberOfItems(), 2);
  grabArrow(0);
  EXPECT_TRUE(widget->IsDragging());
}

TEST_F(GizmoHandled, AProgramMayDisableItFromAnyEvent)
{
  for (const unsigned long event : {vtkCommand::HighlightEvent, vtkCommand::StartInteractionEvent,
                                    vtkCommand::InteractionEvent, vtkCommand::EndInteractionEvent}) {
    const unsigned long tag = widget->AddObserver(event, widget.Get(), &vtkHoldfastGizmoWidget::Off);
    const DisplayPoint place = arrow(0);
    mouse.press(place);
    mouse.moveTo(place + DisplayPoint(9, 9));
    mouse.type("1");
    mouse.release(beside);
    EXPECT_FALSE(widget->IsDragging());
    EXPECT_FALSE(widget->GetEnabled());
    widget->RemoveObserver(tag);
    fixture.interactor().SetEventPosition(200, 150);
    gizmo.SetFrame({1.5, 1, 0}, Eigen::Matrix3d::Identity());
    widget->On();
    gizmo.VisibilityOn();
    const unsigned long hider = widget->AddObserver(event, &gizmo, &vtkHoldfastGizmoRepresentation::VisibilityOff);
    grabArrow(0);
    mouse.release(beside);
    EXPECT_FALSE(widget->IsDragging());
    gizmo.VisibilityOn();
    mouse.moveTo(beside);
    mouse.press(arrow(2));
    mouse.release(beside);
    EXPECT_FALSE(widget->IsDragging());
    widget->RemoveObserver(hider);
    gizmo.SetFrame({1.5, 1, 0}, Eigen::Matrix3d::Identity());
    gizmo.VisibilityOn();
  }
}

TEST_F(GizmoHandled, GoesWithItsWindow)
{
  vtkNew<vtkHoldfastGizmoWidget> other;
  {
    GizmoFixture gone;
    other->SetInteractor(&gone.interactor());
    other->On();
    gone.window().Render();
  }
  EXPECT_FALSE(other->GetEnabled());
  {
    GizmoFixture left;
    {
      vtkNew<vtkHoldfastGizmoWidget> gone;
      gone->SetInteractor(&left.interactor());
      gone->On();
    }
    EXPECT_FALSE(left.interactor().HasObserver(vtkCommand::MiddleButtonPressEvent));
  }
  {
    vtkNew<vtkHoldfastGizmoWidget> deleted;
    deleted->SetInteractor(&fixture.interactor());
    deleted->On();
    ASSERT_EQ(fixture.window().GetRenderers()->GetNumberOfItems(), 3);
  }
  EXPECT_EQ(fixture.window().GetRenderers()->GetNumberOfItems(), 2);
  EXPECT_EQ(fixture.renderer().GetViewProps()->GetNumberOfItems(), 2) << "the surface, and the first gizmo";
  fixture.window().Render();
  mouse.moveTo(arrow(0));
  EXPECT_EQ(widget->GetPart(), GizmoPart::ArrowX);
}

TEST_F(GizmoHandled, ActsInItsOwnRendererAlone)
{
  fixture.renderer().SetViewport(0, 0, 0.5, 1);
  vtkNew<vtkRenderer> right;
  right->SetViewport(0.5, 0, 1, 1);
  right->SetActiveCamera(fixture.renderer().GetActiveCamera());
  fixture.window().AddRenderer(right);
  vtkNew<vtkHoldfastGizmoWidget> other;
  other->SetInteractor(&fixture.interactor());
  other->SetCurrentRenderer(right);
  vtkHoldfastGizmoRepresentation& otherGizmo = *other->GetGizmoRepresentation();
  otherGizmo.SetPixelSize(test::kGizmoRadius);
  otherGizmo.SetFrame({1.5, 1, 0}, Eigen::Matrix3d::Identity());
  other->On();

  gizmo.SetPixelSize(120);
  const DisplayPoint own = placeOnGizmo(gizmo, Vector3::Zero());
  mouse.moveTo(own + 120 * DisplayPoint(-0.6, 0.8));
  EXPECT_EQ(widget->GetPart(), GizmoPart::ViewRing);
  mouse.moveTo(own + DisplayPoint(120, 0));
  EXPECT_EQ(widget->GetPart(), GizmoPart::None) << "its rings end at the edge of its viewport";
  const DisplayPoint middle = placeOnGizmo(otherGizmo, Vector3::Zero());
  mouse.moveTo(middle);
  EXPECT_EQ(other->GetPart(), GizmoPart::Center);
  mouse.moveTo(arrow(0));
  EXPECT_EQ(widget->GetPart(), GizmoPart::ArrowX);
  EXPECT_EQ(other->GetPart(), GizmoPart::None);
  mouse.drag({middle, middle + DisplayPoint(10, 10), middle + DisplayPoint(30, 20)});
  EXPECT_NE(otherGizmo.GetFrame().center, Vector3(1.5, 1, 0));
  EXPECT_EQ(center(), Vector3(1.5, 1, 0));
}

TEST_F(GizmoHandled, ComesBeforeVtksOwnWidgetsAndLeavesThemTheRest)
{
  vtkNew<vtkPointHandleRepresentation3D> point;
  double place[] = {1.5, 1, 0};
  point->SetWorldPosition(place);
  vtkNew<vtkHandleWidget> handle;
  handle->SetRepresentation(point);
  handle->SetInteractor(&fixture.interactor());
  handle->On();
  EventLog handled(*handle, {vtkCommand::StartInteractionEvent, vtkCommand::EndInteractionEvent});
  const DisplayPoint middle = placeOnGizmo(gizmo, Vector3::Zero());
  fixture.window().Render();
  const auto dragMiddle = [&] { mouse.drag({middle, middle + DisplayPoint(9, 0), middle + DisplayPoint(25, 0)}); };
  dragMiddle();
  EXPECT_EQ(lastEvent(), vtkCommand::EndInteractionEvent);
  EXPECT_THAT(handled.events(), IsEmpty());

  gizmo.SetFrame({3, 2, 0}, Eigen::Matrix3d::Identity());
  gizmo.SetPixelSize(20);
  log.clear();
  dragMiddle();
  EXPECT_THAT(handled.events(), ElementsAre(vtkCommand::StartInteractionEvent, vtkCommand::EndInteractionEvent));
  EXPECT_THAT(log.events(), IsEmpty());
  mouse.moveTo(placeOnGizmo(gizmo, Vector3::Zero()));
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
  fixture.interactor().SetEventPosition(200, 150);
  widget->On();
  mouse.moveTo(arrow(0));
  mouse.press(arrow(0));
  EXPECT_FALSE(widget->IsDragging());
  mouse.release(arrow(0));
  mouse.middlePress(arrow(0));
  EXPECT_TRUE(widget->IsDragging());
  mouse.middleRelease(arrow(0) + DisplayPoint(20, 0));
  EXPECT_EQ(lastEvent(), vtkCommand::EndInteractionEvent);
  mouse.key("x");
  mouse.type("4");
  ASSERT_TRUE(widget->IsDragging());
  mouse.key("k");
  EXPECT_FALSE(widget->IsDragging());
}

TEST_F(GizmoHandled, PrintsItsState)
{
  mouse.key("y");
  mouse.type("1.5");
  std::ostringstream text;
  widget->Print(text);
  EXPECT_THAT(text.str(), HasSubstr("Typed: 1.5"));
  EXPECT_THAT(text.str(), HasSubstr("Dragging: 1"));
}

}  // namespace
}  // namespace holdfast
