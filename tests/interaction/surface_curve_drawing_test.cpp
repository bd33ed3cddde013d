#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkRenderWindow.h>

#include <holdfast/widgets/interaction/vtkHoldfastSurfaceCameraStyle.h>

#include "interaction/drawn_curve.h"

namespace holdfast {
namespace {

using test::CurveOnGrid;
using test::EventLog;
using test::kBegins;
using test::kCancels;
using test::kChanges;
using test::kEnds;
using test::kPlaces;
using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

TEST_F(CurveOnGrid, ClicksPlaceVerticesThatShortestPathsJoin)
{
  click({24, 29});
  EXPECT_THAT(widget->GetPlaces(), ElementsAre(24, 29));
  EXPECT_THAT(widget->GetPath(), ElementsAre(24, 25, 26, 27, 28, 29));
  EXPECT_THAT(events, ElementsAre(kBegins, kPlaces, kChanges, kPlaces, kChanges));
  EXPECT_THAT(placed, ElementsAre(24, 29));
  EXPECT_THAT(told, ElementsAre(24, 29));
  EXPECT_EQ(widget->GetWidgetState(), vtkContourWidget::Define);
}

TEST_F(CurveOnGrid, AClickOnTheFirstPlaceCloses)
{
  click({24, 29, 73});
  events.clear();
  mouse().click(fixture.pixelOfVertex(24) + DisplayPoint(7, 7));
  EXPECT_THAT(events, ElementsAre(kChanges, kEnds));
  EXPECT_THAT(told, ElementsAre(24, 29, 73));
  EXPECT_TRUE(widget->IsClosed());
  EXPECT_EQ(widget->GetPath(), closedThrough({24, 29, 73}));
  EXPECT_EQ(widget->GetWidgetState(), vtkContourWidget::Manipulate);
}

TEST_F(CurveOnGrid, EnterAndADoubleClickClose)
{
  for (const char* const key : {"Return", "KP_Enter"}) {
    widget->Clear();
    events.clear();
    click({24, 29});
    mouse().key(key);
    EXPECT_FALSE(widget->IsClosed()) << "two places enclose nothing";
    click(73);
    mouse().key(key);
    EXPECT_TRUE(widget->IsClosed());
    EXPECT_THAT(events, Contains(kEnds).Times(1));
  }
  widget->Clear();
  events.clear();
  click({24, 29});
  mouse().doubleClick(fixture.pixelOfVertex(73));
  EXPECT_TRUE(widget->IsClosed());
  EXPECT_THAT(widget->GetPlaces(), ElementsAre(24, 29, 73));
  EXPECT_THAT(events, Contains(kEnds).Times(1));
  widget->Clear();
  click({24, 29, 73});
  fixture.interactor().InvokeEvent(vtkCommand::LeftButtonDoubleClickEvent);
  EXPECT_TRUE(widget->IsClosed());
}

TEST_F(CurveOnGrid, BackspaceTakesTheLastPlaceBack)
{
  click({24, 29, 73});
  events.clear();
  mouse().key("BackSpace");
  EXPECT_THAT(widget->GetPlaces(), ElementsAre(24, 29));
  EXPECT_THAT(widget->GetPath(), ElementsAre(24, 25, 26, 27, 28, 29));
  mouse().key("Delete");
  mouse().key("BackSpace");
  EXPECT_THAT(widget->GetPlaces(), IsEmpty());
  EXPECT_EQ(widget->GetWidgetState(), vtkContourWidget::Start);
  EXPECT_THAT(events, ElementsAre(kChanges, kChanges, kChanges));
  mouse().key("BackSpace");
  EXPECT_THAT(events, SizeIs(3));
}

TEST_F(CurveOnGrid, EscapeTakesAllPlacesBack)
{
  click({24, 29, 73});
  events.clear();
  mouse().key("Escape");
  EXPECT_THAT(widget->GetPlaces(), IsEmpty());
  EXPECT_THAT(events, ElementsAre(kCancels));
  EXPECT_THAT(told, IsEmpty());
  mouse().key("Escape");
  EXPECT_THAT(events, SizeIs(1));
}

TEST_F(CurveOnGrid, KeysThatAreNotUsedGoOn)
{
  EventLog keys(fixture.interactor(), {vtkCommand::KeyPressEvent});
  for (const char* const key : {"Escape", "BackSpace", "Return"}) mouse().key(key);
  EXPECT_THAT(keys.events(), SizeIs(3));
  click({24, 29, 73});
  for (const char* const key : {"Return", "BackSpace", "Escape"}) mouse().key(key);
  EXPECT_THAT(keys.events(), SizeIs(3));
}

TEST_F(CurveOnGrid, APlaceIsNoPlaceAgain)
{
  click({24, 24, 29, 24});
  EXPECT_THAT(widget->GetPlaces(), ElementsAre(24, 29));
  EXPECT_FALSE(widget->AddPlace(29));
  EXPECT_FALSE(widget->AddPlace(-1));
  EXPECT_FALSE(widget->AddPlace(1000));
}

TEST_F(CurveOnGrid, ADragFromAnywhereTurnsThePicture)
{
  vtkNew<vtkHoldfastSurfaceCameraStyle> style;
  fixture.interactor().SetInteractorStyle(style);
  const Vector3 eye(fixture.renderer().GetActiveCamera()->GetPosition());
  const DisplayPoint at = fixture.pixelOfVertex(24);
  mouse().drag({at, at + DisplayPoint(40, 10), at});
  EXPECT_THAT(events, IsEmpty());
  EXPECT_EQ(style->GetState(), VTKIS_NONE) << "the release reached the style";
  mouse().drag({at, at + DisplayPoint(40, 10)});
  EXPECT_NE(Vector3(fixture.renderer().GetActiveCamera()->GetPosition()), eye);
  EXPECT_THAT(events, IsEmpty());
  mouse().drag({fixture.pixelOfVertex(29), fixture.pixelOfVertex(29) + DisplayPoint(2, 2)});
  EXPECT_THAT(widget->GetPlaces(), ElementsAre(29));
  widget->SetPixelRatio(2);
  mouse().drag({fixture.pixelOfVertex(73), fixture.pixelOfVertex(73) + DisplayPoint(0, 5)});
  EXPECT_THAT(widget->GetPlaces(), ElementsAre(29, 73));
}

TEST_F(CurveOnGrid, TheWayToTheCursorIsShown)
{
  mouse().moveTo(fixture.pixelOfVertex(24));
  EXPECT_THAT(curve().GetPreview(), ElementsAre(24));
  click(24);
  EXPECT_THAT(curve().GetPreview(), IsEmpty());
  mouse().moveTo(fixture.pixelOfVertex(28));
  EXPECT_THAT(curve().GetPreview(), ElementsAre(24, 25, 26, 27, 28));
  EXPECT_THAT(widget->GetPlaces(), ElementsAre(24));
  mouse().leave();
  EXPECT_THAT(curve().GetPreview(), IsEmpty());
  click({28, 72});
  mouse().moveTo(fixture.pixelOfVertex(24) + DisplayPoint(8, 6));
  EXPECT_EQ(curve().GetPreview().back(), 24);
  EXPECT_EQ(fixture.window().GetCurrentCursor(), VTK_CURSOR_HAND);
  mouse().moveTo(fixture.pixelOfVertex(40));
  EXPECT_EQ(fixture.window().GetCurrentCursor(), VTK_CURSOR_CROSSHAIR);
  mouse().key("Return");
  EXPECT_THAT(curve().GetPreview(), IsEmpty());
  widget->Clear();
  widget->FollowCursorOff();
  mouse().moveTo(fixture.pixelOfVertex(24));
  EXPECT_THAT(curve().GetPreview(), IsEmpty());
}

TEST_F(CurveOnGrid, HoveringWaitsWhileTheCameraMoves)
{
  vtkNew<vtkHoldfastSurfaceCameraStyle> style;
  fixture.interactor().SetInteractorStyle(style);
  mouse().press({3, 3});
  // The style begins with this one, which it sees after the widget.
  mouse().moveTo({10, 3});
  mouse().moveTo(fixture.pixelOfVertex(24));
  EXPECT_THAT(curve().GetPreview(), IsEmpty());
  mouse().release(fixture.pixelOfVertex(24));
}

}  // namespace
}  // namespace holdfast
