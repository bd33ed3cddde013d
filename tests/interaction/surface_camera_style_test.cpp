#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkHandleWidget.h>
#include <vtkPointHandleRepresentation3D.h>
#include <vtkRenderWindow.h>
#include <vtkWidgetEvent.h>

#include <holdfast/widgets/camera/camera_state.h>
#include <holdfast/widgets/interaction/interaction_events.h>
#include <holdfast/widgets/picking/surface_picker.h>

#include "holdfast/widgets/interaction/vtkHoldfastSurfaceCameraStyle.h"
#include "interaction/interaction_fixture.h"
#include "support/meshes.h"

namespace holdfast {
namespace {

using test::EventLog;
using test::InteractionFixture;
using testing::ElementsAre;
using testing::IsEmpty;

/// A box before the style's camera, which is seen from a corner.
struct CameraOfBox : testing::Test {
  CameraOfBox()
  {
    style->SetSurface(fixture.surface());
    fixture.interactor().SetInteractorStyle(style);
    lookFromACorner(camera());
    fixture.renderer().ResetCameraClippingRange();
    at = fixture.pixelOf({1.8, 1.8, 2});
    under = SurfacePicker(fixture.surface()).pick(fixture.renderer(), at.x(), at.y(), PickKind::Face, 0).value().place;
  }

  static void lookFromACorner(vtkCamera& camera)
  {
    camera.Azimuth(30);
    camera.Elevation(20);
    camera.OrthogonalizeViewUp();
  }

  [[nodiscard]] vtkCamera& camera() const { return *fixture.renderer().GetActiveCamera(); }
  [[nodiscard]] Vector3 eye() const { return Vector3(camera().GetPosition()); }
  [[nodiscard]] Vector3 focus() const { return Vector3(camera().GetFocalPoint()); }
  [[nodiscard]] DisplayPoint shown(const Vector3& place) const
  {
    return toDisplay(fixture.renderer(), place).head<2>();
  }

  InteractionFixture fixture{test::box({2, 2, 2}, 4)};
  vtkNew<vtkHoldfastSurfaceCameraStyle> style;
  DisplayPoint at;  // a pixel of the box, and what is under it
  Vector3 under;
};

TEST_F(CameraOfBox, LeftDragTurnsAboutThePlaceUnderTheCursor)
{
  const double before = (eye() - under).norm();
  const DisplayPoint seen = shown(under);
  const Vector3 from = eye();
  fixture.mouse().drag({at, at + DisplayPoint(30, 0), at + DisplayPoint(60, 20)});
  EXPECT_GT((eye() - from).norm(), 0.5);
  EXPECT_NEAR((eye() - under).norm(), before, 1e-9);
  EXPECT_LT((shown(under) - seen).norm(), 1e-6) << "it stays where it is on the screen";
}

TEST_F(CameraOfBox, ADragBegunAndEndedInSmallStepsTurnsByAllOfIt)
{
  fixture.mouse().drag({at, at + DisplayPoint(50, 0)});
  const Vector3 atOnce = eye();
  InteractionFixture other{test::box({2, 2, 2}, 4)};
  other.interactor().SetInteractorStyle(style);
  lookFromACorner(*other.renderer().GetActiveCamera());
  other.mouse().drag(
      {at, at + DisplayPoint(2, 0), at + DisplayPoint(3, 0), at + DisplayPoint(20, 0), at + DisplayPoint(50, 0)});
  EXPECT_LT((Vector3(other.renderer().GetActiveCamera()->GetPosition()) - atOnce).norm(), 1e-9);
}

TEST_F(CameraOfBox, MiddleAndShiftRightShiftThePlaceWithTheCursor)
{
  const DisplayPoint seen = shown(under);
  fixture.mouse().middlePress(at);
  fixture.mouse().moveTo(at + DisplayPoint(40, 10));
  fixture.mouse().middleRelease(at + DisplayPoint(40, 10));
  EXPECT_LT((shown(under) - seen - DisplayPoint(40, 10)).norm(), 1e-6);
  fixture.mouse().rightPress(at + DisplayPoint(40, 10), {.shift = true});
  fixture.mouse().moveTo(at, {.shift = true});
  fixture.mouse().rightRelease(at, {.shift = true});
  EXPECT_LT((shown(under) - seen).norm(), 1e-6);
}

TEST_F(CameraOfBox, TheWheelGoesNearerToThePlaceUnderTheCursorByAFifthANotch)
{
  const DisplayPoint seen = shown(under);
  const double before = (eye() - under).norm();
  fixture.mouse().wheel(at, 1);
  EXPECT_NEAR((eye() - under).norm(), before / 1.2, 1e-9);
  EXPECT_LT((shown(under) - seen).norm(), 1e-6);
  fixture.mouse().wheel(at, -1);
  EXPECT_NEAR((eye() - under).norm(), before, 1e-9);
  style->SetMouseWheelMotionFactor(0.25);
  fixture.mouse().wheel(at, 1);
  EXPECT_NEAR((eye() - under).norm(), before / std::pow(1.2, 0.25), 1e-9);
}

TEST_F(CameraOfBox, BesideTheSurfaceItTurnsAboutThePlaceAtTheDepthOfTheFocus)
{
  const DisplayPoint beside(2, 2);
  const Vector3 pivot = atDepthOf(fixture.renderer(), focus(), beside);
  const double before = (eye() - pivot).norm();
  fixture.mouse().drag({beside, beside + DisplayPoint(40, 40)});
  EXPECT_NEAR((eye() - pivot).norm(), before, 1e-9);
  EXPECT_NE(eye(), Vector3::Zero());
}

TEST_F(CameraOfBox, AHandThatShakesLessThanFourPixelsMovesNothing)
{
  const EventLog log(*style, {vtkCommand::StartInteractionEvent, vtkCommand::InteractionEvent});
  const unsigned long before = camera().GetMTime();
  fixture.mouse().drag({at, at + DisplayPoint(3, 2)});
  EXPECT_EQ(camera().GetMTime(), before);
  EXPECT_THAT(log.events(), IsEmpty());
  style->SetPixelRatio(2);
  fixture.mouse().drag({at, at + DisplayPoint(6, 4)});
  EXPECT_EQ(camera().GetMTime(), before);
  fixture.mouse().drag({at, at + DisplayPoint(7, 4)});
  EXPECT_NE(camera().GetMTime(), before);
}

TEST_F(CameraOfBox, TellsWhenADragBeginsGoesOnAndEnds)
{
  const EventLog log(*style, {vtkCommand::StartInteractionEvent, vtkCommand::InteractionEvent,
                              vtkCommand::EndInteractionEvent, ContextMenuRequestEvent});
  fixture.mouse().drag({at, at + DisplayPoint(10, 0), at + DisplayPoint(20, 0)});
  EXPECT_THAT(log.events(), ElementsAre(vtkCommand::StartInteractionEvent, vtkCommand::InteractionEvent,
                                        vtkCommand::InteractionEvent, vtkCommand::EndInteractionEvent));
}

TEST_F(CameraOfBox, ARightClickAsksForAMenuAndARightDragTurns)
{
  EventLog log(*style, {vtkCommand::StartInteractionEvent, ContextMenuRequestEvent});
  fixture.mouse().rightPress(at);
  fixture.mouse().rightRelease(at);
  EXPECT_THAT(log.events(), ElementsAre(ContextMenuRequestEvent));
  log.clear();
  fixture.mouse().rightPress(at);
  fixture.mouse().moveTo(at + DisplayPoint(30, 0));
  fixture.mouse().rightRelease(at + DisplayPoint(30, 0));
  EXPECT_THAT(log.events(), ElementsAre(vtkCommand::StartInteractionEvent));
}

TEST_F(CameraOfBox, IsBusyAsLongAsItMovesTheCamera)
{
  EXPECT_FALSE(isCameraMoving(fixture.interactor()));
  fixture.mouse().press(at);
  EXPECT_FALSE(isCameraMoving(fixture.interactor()));
  fixture.mouse().moveTo(at + DisplayPoint(30, 0));
  EXPECT_TRUE(isCameraMoving(fixture.interactor()));
  style->Cancel();
  EXPECT_FALSE(isCameraMoving(fixture.interactor()));
  const unsigned long before = camera().GetMTime();
  fixture.mouse().moveTo(at + DisplayPoint(60, 0));
  EXPECT_EQ(camera().GetMTime(), before);
}

TEST_F(CameraOfBox, ASecondButtonDoesNotDisturbTheDragOfTheFirst)
{
  fixture.mouse().press(at);
  fixture.mouse().moveTo(at + DisplayPoint(30, 0));
  fixture.mouse().middlePress(at + DisplayPoint(30, 0));
  fixture.mouse().middleRelease(at + DisplayPoint(30, 0));
  EXPECT_TRUE(isCameraMoving(fixture.interactor()));
  fixture.mouse().release(at + DisplayPoint(30, 0));
  EXPECT_FALSE(isCameraMoving(fixture.interactor()));
}

TEST_F(CameraOfBox, BindingsCanBeChanged)
{
  style->GetEventTranslator()->SetTranslation(vtkCommand::LeftButtonPressEvent, vtkWidgetEvent::NoEvent);
  // The first translation that fits counts.
  style->GetEventTranslator()->SetTranslation(vtkCommand::MiddleButtonPressEvent, vtkWidgetEvent::NoEvent);
  style->GetEventTranslator()->SetTranslation(vtkCommand::MiddleButtonPressEvent, vtkWidgetEvent::Rotate);
  const unsigned long before = camera().GetMTime();
  fixture.mouse().drag({at, at + DisplayPoint(30, 0)});
  EXPECT_EQ(camera().GetMTime(), before);
  const Vector3 direction = (focus() - eye()).normalized();
  fixture.mouse().middlePress(at);
  fixture.mouse().moveTo(at + DisplayPoint(30, 0));
  fixture.mouse().middleRelease(at + DisplayPoint(30, 0));
  EXPECT_LT((focus() - eye()).normalized().dot(direction), 0.999) << "turned, not shifted";
}

TEST_F(CameraOfBox, WidgetsComeFirst)
{
  vtkNew<vtkPointHandleRepresentation3D> cross;
  double place[3] = {under.x(), under.y(), under.z()};
  cross->SetWorldPosition(place);
  cross->ActiveRepresentationOn();
  vtkNew<vtkHandleWidget> handle;
  handle->SetInteractor(&fixture.interactor());
  handle->SetRepresentation(cross);
  handle->On();
  fixture.window().Render();
  const unsigned long before = camera().GetMTime();
  fixture.mouse().drag({at, at + DisplayPoint(30, 0)});
  EXPECT_EQ(camera().GetMTime(), before);
  handle->Off();
  fixture.mouse().drag({at, at + DisplayPoint(30, 0)});
  EXPECT_NE(camera().GetMTime(), before);
}

TEST_F(CameraOfBox, MovesTheCameraOfTheRendererUnderTheCursor)
{
  vtkNew<vtkRenderer> right;
  fixture.renderer().SetViewport(0, 0, 0.5, 1);
  right->SetViewport(0.5, 0, 1, 1);
  fixture.window().AddRenderer(right);
  const unsigned long before = camera().GetMTime();
  const Vector3 eyeOfRight(right->GetActiveCamera()->GetPosition());
  fixture.mouse().drag({{300, 150}, {340, 150}});
  EXPECT_EQ(camera().GetMTime(), before);
  EXPECT_NE(Vector3(right->GetActiveCamera()->GetPosition()), eyeOfRight);
}

TEST_F(CameraOfBox, KeysOfVtkAreNotBound)
{
  const EventLog log(fixture.interactor(), {vtkCommand::ExitEvent, vtkCommand::UserEvent});
  const unsigned long before = camera().GetMTime();
  for (const char* key : {"q", "e", "f", "r", "w", "s", "3", "p", "u"}) fixture.mouse().key(key);
  EXPECT_THAT(log.events(), IsEmpty());
  EXPECT_EQ(camera().GetMTime(), before);
}

}  // namespace
}  // namespace holdfast
