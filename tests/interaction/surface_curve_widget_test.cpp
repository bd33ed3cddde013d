#include <sstream>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkHandleWidget.h>
#include <vtkInteractorEventRecorder.h>
#include <vtkPointHandleRepresentation3D.h>
#include <vtkPolyData.h>
#include <vtkRenderWindow.h>
#include <vtkWidgetEvent.h>
#include <vtkWidgetEventTranslator.h>

#include "holdfast/widgets/interaction/vtkHoldfastSurfaceCurveWidget.h"
#include "interaction/drawn_curve.h"
#include "support/meshes.h"
#include "support/temporary_folder.h"

namespace holdfast {
namespace {

using test::CurveOnGrid;
using test::kBegins;
using test::kChanges;
using test::kEnds;
using test::kMoves;
using test::kPlaces;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST_F(CurveOnGrid, FollowsTheSurface)
{
  click({24, 29, 73});
  mouse().key("Return");
  auto moved = std::make_shared<Positions>(fixture.surface()->positions());
  moved->col(2).array() += 0.25;
  widget->SetSurface(std::make_shared<const VisibleSurface>(fixture.surface()->movedTo(moved)));
  vtkPolyData& line = *curve().GetContourRepresentationAsPolyData();
  ASSERT_EQ(line.GetNumberOfPoints(), static_cast<vtkIdType>(closedThrough({24, 29, 73}).size() + 1));
  EXPECT_EQ(line.GetBounds()[4], 0.25);
  EXPECT_EQ(line.GetBounds()[5], 0.25);
  double place[3];
  curve().GetNthNodeWorldPosition(1, place);
  EXPECT_EQ(Vector3(place), Vector3(7, 2, 0.25));
  curve().GetIntermediatePointWorldPosition(0, 0, place);
  EXPECT_EQ(Vector3(place), Vector3(3, 2, 0.25));

  const Model other = makeModel(test::grid(3, 3), "other");
  widget->SetSurface(std::make_shared<const VisibleSurface>(other));
  EXPECT_THAT(widget->GetPlaces(), IsEmpty());
  EXPECT_FALSE(widget->IsClosed());
  widget->SetSurface(nullptr);
}

TEST_F(CurveOnGrid, DisablingKeepsTheCurve)
{
  click({24, 29});
  mouse().press(fixture.pixelOfVertex(73));
  widget->Off();
  mouse().release(fixture.pixelOfVertex(73));
  EXPECT_THAT(widget->GetPlaces(), ElementsAre(24, 29));
  EXPECT_EQ(fixture.window().GetCurrentCursor(), VTK_CURSOR_DEFAULT);
  fixture.enable(*widget);
  mouse().release(fixture.pixelOfVertex(73));
  EXPECT_THAT(widget->GetPlaces(), ElementsAre(24, 29));
  click(73);
  EXPECT_THAT(widget->GetPlaces(), ElementsAre(24, 29, 73));
}

TEST_F(CurveOnGrid, ObserversMayTakeAllAwayAtAnyEvent)
{
  for (const unsigned long event : {kBegins, kPlaces, kChanges, kMoves, kEnds}) {
    const unsigned long tag = widget->AddObserver(event, widget.Get(), &vtkHoldfastSurfaceCurveWidget::Clear);
    click({24, 29, 73});
    mouse().key("Return");
    mouse().drag({fixture.pixelOfVertex(29), fixture.pixelOfVertex(30), fixture.pixelOfVertex(41)});
    widget->RemoveObserver(tag);
    click({24, 29, 73});
    EXPECT_THAT(widget->GetPlaces(), ElementsAre(24, 29, 73));
    widget->Clear();
  }
}

TEST_F(CurveOnGrid, OtherRenderersKeepTheirEvents)
{
  vtkNew<vtkRenderer> other;
  fixture.renderer().SetViewport(0, 0, 0.5, 1);
  other->SetViewport(0.5, 0, 1, 1);
  fixture.window().AddRenderer(other);
  mouse().click({300, 150});
  EXPECT_THAT(events, IsEmpty());
  EXPECT_THAT(curve().GetPreview(), IsEmpty());
  click(24);
  EXPECT_THAT(widget->GetPlaces(), ElementsAre(24));
}

TEST_F(CurveOnGrid, PriorityTellsWhoIsAskedFirst)
{
  vtkNew<vtkHandleWidget> handle;
  vtkNew<vtkPointHandleRepresentation3D> ball;
  handle->SetRepresentation(ball);
  handle->SetInteractor(&fixture.interactor());
  handle->SetCurrentRenderer(&fixture.renderer());
  ball->PlaceWidget(fixture.renderer().ComputeVisiblePropBounds());
  double place[3] = {7, 2, 0};
  ball->SetWorldPosition(place);
  handle->On();
  widget->SetPlaces({24, 29, 73});
  widget->CloseLoop();
  widget->SetPriority(0.6F);
  mouse().drag({fixture.pixelOfVertex(29), fixture.pixelOfVertex(30)});
  EXPECT_THAT(widget->GetPlaces(), ElementsAre(24, 30, 73));
  EXPECT_EQ(Vector3(ball->GetWorldPosition()), Vector3(7, 2, 0));
  widget->SetPlaces({24, 29, 73});
  widget->CloseLoop();
  widget->SetPriority(0.4F);
  mouse().drag({fixture.pixelOfVertex(29), fixture.pixelOfVertex(30)});
  EXPECT_THAT(widget->GetPlaces(), ElementsAre(24, 29, 73));
  EXPECT_GT(ball->GetWorldPosition()[0], 7.5);
}

TEST_F(CurveOnGrid, BindingsCanBeChanged)
{
  widget->Off();
  vtkWidgetEventTranslator& translator = *widget->GetEventTranslator();
  translator.ClearEvents();
  translator.SetTranslation(vtkCommand::RightButtonPressEvent, vtkWidgetEvent::Select);
  translator.SetTranslation(vtkCommand::RightButtonReleaseEvent, vtkWidgetEvent::EndSelect);
  translator.SetTranslation(vtkCommand::MiddleButtonPressEvent, vtkWidgetEvent::AddFinalPoint);
  fixture.enable(*widget);
  click({24, 29, 73});
  EXPECT_THAT(events, IsEmpty());
  for (const Index vertex : {24, 29, 73}) {
    mouse().rightPress(fixture.pixelOfVertex(vertex));
    mouse().rightRelease(fixture.pixelOfVertex(vertex));
  }
  mouse().middlePress({5, 5});
  EXPECT_THAT(widget->GetPlaces(), ElementsAre(24, 29, 73));
  EXPECT_TRUE(widget->IsClosed());
}

TEST_F(CurveOnGrid, ARecordedGestureDrawsTheSameAgain)
{
  const test::TemporaryFolder folder;
  const std::string path = (folder.path() / "curve.log").string();
  vtkNew<vtkInteractorEventRecorder> recorder;
  recorder->SetInteractor(&fixture.interactor());
  recorder->SetFileName(path.c_str());
  recorder->On();
  recorder->Record();
  click({24, 29, 73});
  mouse().key("Return");
  recorder->Stop();
  recorder->Off();
  const auto recorded = std::exchange(events, {});
  ASSERT_THAT(recorded, Contains(kEnds));
  widget->Clear();

  vtkNew<vtkInteractorEventRecorder> player;
  player->SetInteractor(&fixture.interactor());
  player->SetFileName(path.c_str());
  player->On();
  player->Play();
  EXPECT_EQ(events, recorded);
  EXPECT_EQ(widget->GetPath(), closedThrough({24, 29, 73}));
}

TEST_F(CurveOnGrid, PrintsItsState)
{
  click({24, 29});
  std::ostringstream text;
  curve().Print(text);
  EXPECT_THAT(text.str(), HasSubstr("Places: 24 29\n"));
}

}  // namespace
}  // namespace holdfast
