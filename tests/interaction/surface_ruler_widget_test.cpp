#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkDistanceWidget.h>
#include <vtkPropCollection.h>
#include <vtkRenderWindow.h>
#include <vtkWidgetEvent.h>
#include <vtkWidgetEventTranslator.h>

#include <holdfast/widgets/interaction/vtkHoldfastSurfaceCameraStyle.h>
#include <holdfast/words/error.h>

#include "holdfast/widgets/interaction/vtkHoldfastSurfaceRulerWidget.h"
#include "interaction/call_data_log.h"
#include "interaction/interaction_fixture.h"
#include "interaction/recorded_gesture.h"
#include "interaction/widget_events.h"
#include "support/meshes.h"

namespace holdfast {
namespace {

using test::InteractionFixture;
using test::kBegins;
using test::kCancels;
using test::kEnds;
using test::kMoves;
using test::kPlaces;
using testing::ElementsAre;
using testing::IsEmpty;

struct RulerFixture : InteractionFixture {
  explicit RulerFixture(Mesh mesh = test::grid(4, 3), int width = 400, int height = 300)
      : InteractionFixture(std::move(mesh), width, height)
  {
    widget->SetSurface(surface());
    enable(*widget);
  }

  void draw(Index from, Index to)
  {
    mouse().click(pixelOfVertex(from));
    mouse().click(pixelOfVertex(to));
  }

  /// The mesh twice as large, as a deformation of that at rest.
  [[nodiscard]] std::shared_ptr<const VisibleSurface> doubled() const
  {
    return std::make_shared<const VisibleSurface>(
        surface()->movedTo(std::make_shared<Positions>(2 * model().mesh.positions)));
  }

  /// The vertex of an end; -1 where it lies on none.
  [[nodiscard]] Index vertexOfEnd(int end)
  {
    const auto location = widget->GetLocation(end);
    const AtVertex* const at = location ? std::get_if<AtVertex>(&*location) : nullptr;
    return at ? at->vertex : -1;
  }

  vtkNew<vtkHoldfastSurfaceRulerWidget> widget;
  test::EventLog log{*widget, {kBegins, kMoves, kPlaces, kEnds, kCancels}};
  test::CallDataLog<int> placed{*widget, kPlaces};
};

struct Ruler : RulerFixture, testing::Test {};

TEST_F(Ruler, TwoClicksMeasureBetweenPointsOfTheSurface)
{
  EXPECT_EQ(widget->GetDistance(), 0);
  draw(5, 13);
  EXPECT_EQ(vertexOfEnd(0), 5);
  EXPECT_EQ(vertexOfEnd(1), 13);
  EXPECT_EQ(widget->GetDistance(), std::hypot(3, 1)) << "not to the pixel, to the last digit";
  EXPECT_EQ(widget->GetRestDistance(), widget->GetDistance());
  EXPECT_EQ(widget->GetDistance(), widget->GetRulerRepresentation()->GetDistance());
  EXPECT_THAT(log.events(), ElementsAre(kBegins, kPlaces, kMoves, kPlaces, kEnds));
  EXPECT_THAT(placed.data(), ElementsAre(0, 1));
  mouse().click(pixelOfVertex(9));
  EXPECT_EQ(vertexOfEnd(0), 9) << "the next ruler begins there";
}

TEST_F(Ruler, TheSecondEndGoesWithTheCursorAndStaysOnTheSurface)
{
  mouse().click(pixelOfVertex(5));
  EXPECT_EQ(widget->GetDistance(), 0);
  mouse().moveTo(pixelOfVertex(7));
  EXPECT_EQ(widget->GetDistance(), 2);
  mouse().moveTo({1, 1});
  EXPECT_EQ(vertexOfEnd(1), 7) << "beside the surface";
  mouse().click({1, 1});
  EXPECT_TRUE(widget->IsUnderWay());
  const auto tool = widget->GetPlacer();
  tool->SetKind(PickKind::Face);
  mouse().click(pixelOf({2.65, 1.35, 0}));
  EXPECT_TRUE(std::holds_alternative<AtFace>(*widget->GetLocation(1)));
  EXPECT_FALSE(widget->IsUnderWay());
}

TEST_F(Ruler, NothingBeginsBesideTheSurface)
{
  mouse().click({1, 1});
  EXPECT_FALSE(widget->IsUnderWay());
  EXPECT_THAT(log.events(), IsEmpty());
  mouse().doubleClick(pixelOfVertex(5));
  EXPECT_TRUE(widget->IsUnderWay()) << "a double click places one end";
}

TEST_F(Ruler, TheCameraTurnsBetweenTheClicks)
{
  vtkNew<vtkHoldfastSurfaceCameraStyle> style;
  interactor().SetInteractorStyle(style);
  const auto eye = [&] { return Vector3(renderer().GetActiveCamera()->GetPosition()); };
  mouse().click(pixelOfVertex(5));
  const Vector3 before = eye();
  const DisplayPoint from = pixelOfVertex(7);
  mouse().drag({from, from + DisplayPoint(8, 0), from + DisplayPoint(20, 0)});
  EXPECT_GT((eye() - before).norm(), 0.1);
  EXPECT_TRUE(widget->IsUnderWay());
  const Vector3 after = eye();
  mouse().moveTo({150, 150});
  EXPECT_EQ(eye(), after) << "the style has seen the release";
  mouse().click(pixelOfVertex(13));
  EXPECT_EQ(widget->GetDistance(), std::hypot(3, 1));
  mouse().moveTo({160, 150});
  mouse().moveTo({190, 150});
  EXPECT_EQ(eye(), after) << "and that of the second click";
}

TEST_F(Ruler, EndsCanBeDragged)
{
  vtkNew<vtkHoldfastSurfaceCameraStyle> style;
  interactor().SetInteractorStyle(style);
  draw(5, 13);
  log.clear();
  const Vector3 eye(renderer().GetActiveCamera()->GetPosition());
  mouse().drag({pixelOfVertex(13), pixelOfVertex(12), {1, 1}, pixelOfVertex(7)});
  EXPECT_EQ(vertexOfEnd(0), 5);
  EXPECT_EQ(vertexOfEnd(1), 7);
  EXPECT_EQ(widget->GetDistance(), 2);
  EXPECT_THAT(log.events(), ElementsAre(kBegins, kMoves, kMoves, kMoves, kEnds));
  mouse().drag({pixelOfVertex(5), pixelOfVertex(0)});
  EXPECT_EQ(vertexOfEnd(0), 0);
  EXPECT_EQ(Vector3(renderer().GetActiveCamera()->GetPosition()), eye) << "drags of ends are not the camera's";
  mouse().press(pixelOfVertex(7));
  mouse().moveTo({1, 1});
  mouse().release({1, 1});
  EXPECT_EQ(vertexOfEnd(1), 7) << "beside the surface it stays";
}

TEST_F(Ruler, EscapeTakesBackAHalfDrawnRulerOrADrag)
{
  mouse().key("Escape");
  EXPECT_THAT(log.events(), IsEmpty()) << "there is nothing to take back";
  mouse().click(pixelOfVertex(5));
  mouse().moveTo(pixelOfVertex(7));
  mouse().key("Escape");
  EXPECT_THAT(log.events(), ElementsAre(kBegins, kPlaces, kMoves, kCancels));
  EXPECT_FALSE(widget->GetLocation(0));
  EXPECT_EQ(widget->GetDistance(), 0);
  draw(5, 13);
  log.clear();
  mouse().moveTo(pixelOfVertex(13));
  mouse().press(pixelOfVertex(13));
  mouse().moveTo(pixelOfVertex(7));
  mouse().key("Escape");
  EXPECT_THAT(log.events(), ElementsAre(kBegins, kMoves, kCancels));
  EXPECT_EQ(vertexOfEnd(1), 13);
  mouse().moveTo(pixelOfVertex(8));
  mouse().release(pixelOfVertex(8));
  EXPECT_EQ(vertexOfEnd(1), 13) << "the end was let go";
  EXPECT_THAT(log.events(), ElementsAre(kBegins, kMoves, kCancels));
  mouse().drag({pixelOfVertex(13), pixelOfVertex(7)});
  EXPECT_EQ(vertexOfEnd(1), 7) << "and can be grabbed again";
}

TEST_F(Ruler, FollowsADeformationAndKnowsBothDistances)
{
  widget->SetUnits("mm");
  draw(5, 13);
  widget->SetSurface(doubled());
  EXPECT_DOUBLE_EQ(widget->GetDistance(), 2 * std::hypot(3, 1));
  EXPECT_DOUBLE_EQ(widget->GetRestDistance(), std::hypot(3, 1));
  EXPECT_EQ(widget->GetRulerRepresentation()->GetLabel(), "6.325 mm (rest 3.162)");
  double place[3];
  widget->GetDistanceRepresentation()->GetPoint2WorldPosition(place);
  EXPECT_EQ(Vector3(place), Vector3(6, 4, 0)) << "as VTK's own interface says";
  renderer().ResetCamera(0, 8, 0, 6, 0, 0);
  mouse().drag({pixelOf({6, 4, 0}), pixelOf({4, 2, 0})});
  EXPECT_EQ(widget->GetDistance(), 4) << "dragged on the deformed surface";
  EXPECT_EQ(widget->GetRestDistance(), 2);
  widget->SetUnits("");
  EXPECT_EQ(widget->GetRulerRepresentation()->GetLabel(), "4 (rest 2)");
}

TEST_F(Ruler, GoesWithItsMesh)
{
  draw(5, 13);
  const Model other = makeModel(test::grid(1, 1), "other");
  widget->SetSurface(std::make_shared<const VisibleSurface>(other));
  EXPECT_FALSE(widget->GetLocation(0));
  widget->SetSurface(surface());
  mouse().click(pixelOfVertex(5));
  log.clear();
  widget->SetSurface(nullptr);
  EXPECT_THAT(log.events(), ElementsAre(kCancels));
  EXPECT_FALSE(widget->IsUnderWay());
}

TEST_F(Ruler, IsSetFromOutside)
{
  const AtFace inFace{2, {0.25, 0.25, 0.5}};
  widget->SetLocations(AtVertex{0}, AtEdge{6, 7, 0.25});
  EXPECT_EQ(widget->GetDistance(), Vector3(1.75, 1, 0).norm());
  EXPECT_THAT(log.events(), IsEmpty());
  mouse().drag({pixelOfVertex(0), pixelOfVertex(1)});
  EXPECT_EQ(vertexOfEnd(0), 1) << "its ends can be dragged";
  EXPECT_THROW(widget->SetLocations(inFace, AtVertex{99}), InputError);
  EXPECT_EQ(vertexOfEnd(0), 1) << "nothing has changed";
  EXPECT_EQ(widget->GetDistance(), Vector3(0.75, 1, 0).norm());
  widget->SetLocations(AtNear{{1, 1, 5}}, AtVertex{8});
  EXPECT_EQ(widget->GetDistance(), 2);
  mouse().moveTo(pixelOfVertex(6));
  mouse().press(pixelOfVertex(6));
  mouse().moveTo(pixelOfVertex(0));
  widget->Cancel();
  mouse().release(pixelOfVertex(0));
  EXPECT_EQ(widget->GetDistance(), 2);
  log.clear();
  widget->Clear();
  EXPECT_EQ(widget->GetDistance(), 0);
  EXPECT_THAT(log.events(), IsEmpty());
  draw(5, 7);
  EXPECT_EQ(widget->GetDistance(), 2) << "the next clicks draw a new one";
  mouse().drag({pixelOfVertex(7), pixelOfVertex(8)});
  EXPECT_EQ(widget->GetDistance(), 3);
}

TEST_F(Ruler, CanBeSetBeforeItIsEnabled)
{
  vtkNew<vtkHoldfastSurfaceRulerWidget> early;
  early->SetSurface(surface());
  early->SetLocations(AtVertex{0}, AtVertex{4});
  EXPECT_EQ(early->GetDistance(), 4);
  early->SetInteractor(&interactor());
  early->SetEnabled(1);
  EXPECT_EQ(early->GetDistance(), 4);
  widget->SetEnabled(0);
  mouse().drag({pixelOfVertex(4), pixelOfVertex(2)});
  EXPECT_EQ(early->GetDistance(), 2);
}

TEST_F(Ruler, DisabledItKeepsARulerThatIsDrawnAndCancelsWhatIsUnderWay)
{
  mouse().click(pixelOfVertex(5));
  widget->SetEnabled(0);
  EXPECT_EQ(log.events().back(), kCancels);
  enable(*widget);
  draw(5, 13);
  mouse().moveTo(pixelOfVertex(13));
  mouse().press(pixelOfVertex(13));
  mouse().moveTo(pixelOfVertex(7));
  widget->SetEnabled(0);
  EXPECT_EQ(vertexOfEnd(1), 13);
  const test::EventLog moves(interactor(), {vtkCommand::MouseMoveEvent});
  mouse().moveTo(pixelOfVertex(8));
  EXPECT_EQ(moves.events().size(), 1U) << "nobody holds the mouse";
  enable(*widget);
  EXPECT_EQ(widget->GetDistance(), std::hypot(3, 1));
  mouse().drag({pixelOfVertex(13), pixelOfVertex(7)});
  EXPECT_EQ(widget->GetDistance(), 2);
}

TEST_F(Ruler, ActsInItsRendererAlone)
{
  renderer().SetViewport(0, 0, 0.5, 1);
  vtkNew<vtkRenderer> above;
  above->SetLayer(1);
  window().SetNumberOfLayers(2);
  window().AddRenderer(above);
  vtkNew<vtkRenderer> other;
  other->SetViewport(0.5, 0, 1, 1);
  other->SetActiveCamera(renderer().GetActiveCamera());
  window().AddRenderer(other);
  mouse().click(pixelOfVertex(7) + DisplayPoint(200, 0));
  EXPECT_FALSE(widget->IsUnderWay());
  draw(6, 8);
  EXPECT_EQ(widget->GetDistance(), 2);
  mouse().drag({pixelOfVertex(8), pixelOfVertex(8) + DisplayPoint(200, 0), pixelOfVertex(7)});
  EXPECT_EQ(widget->GetDistance(), 1) << "a layer above, with another camera, does not count";
}

TEST_F(Ruler, GrabsFromFartherOnADisplayOfManyPixels)
{
  draw(5, 13);
  const DisplayPoint beside = pixelOfVertex(13) + DisplayPoint(10, 8);
  mouse().drag({beside, pixelOfVertex(7)});
  EXPECT_EQ(vertexOfEnd(1), 13);
  widget->SetPixelRatio(2);
  window().Render();
  mouse().drag({beside, pixelOfVertex(7)});
  EXPECT_EQ(vertexOfEnd(1), 7);
}

TEST_F(Ruler, StandsBesideAWidgetOfVTKAndItsBindingsCanBeChanged)
{
  vtkNew<vtkDistanceWidget> stock;
  stock->SetInteractor(&interactor());
  stock->SetCurrentRenderer(&renderer());
  stock->CreateDefaultRepresentation();
  stock->SetPriority(0.6F);
  stock->SetEnabled(1);
  draw(5, 7);
  EXPECT_EQ(stock->GetWidgetState(), vtkDistanceWidget::Manipulate);
  EXPECT_THAT(log.events(), IsEmpty()) << "the stock widget takes the presses";
  stock->SetEnabled(0);
  widget->SetEnabled(0);
  widget->GetEventTranslator()->RemoveTranslation(vtkCommand::LeftButtonReleaseEvent);
  widget->GetEventTranslator()->SetTranslation(vtkCommand::MiddleButtonReleaseEvent, vtkWidgetEvent::EndSelect);
  enable(*widget);
  mouse().click(pixelOfVertex(5));
  EXPECT_FALSE(widget->IsUnderWay());
  mouse().middleRelease(pixelOfVertex(5));
  EXPECT_TRUE(widget->IsUnderWay());
}

TEST_F(Ruler, AReplayedGestureDoesTheSame)
{
  const std::string events = test::recorded(interactor(), [&] {
    draw(5, 13);
    mouse().drag({pixelOfVertex(13), pixelOfVertex(12), pixelOfVertex(8)});
  });
  EXPECT_EQ(vertexOfEnd(1), 8);
  RulerFixture again;
  test::replay(events, again.interactor());
  EXPECT_EQ(again.vertexOfEnd(1), 8);
  EXPECT_EQ(again.log.events(), log.events());
}

TEST_F(Ruler, GivesItsActors)
{
  vtkNew<vtkPropCollection> actors;
  widget->GetRepresentation()->GetActors2D(actors);
  EXPECT_EQ(actors->GetNumberOfItems(), 3);
}

const std::vector<int> kRulerColor{156, 43, 255};

TEST_F(Ruler, IsDrawnWithAHaloAndALabel)
{
  const auto accent = [&] { return countPixels(kRulerColor, 30); };
  const auto light = [&] { return countPixels({255, 255, 255}, 20); };
  EXPECT_EQ(accent(), 0);
  mouse().click(pixelOfVertex(5));
  mouse().moveTo(pixelOfVertex(8));
  EXPECT_GT(accent(), 200) << "while it is drawn";
  mouse().click(pixelOfVertex(8));
  const int once = accent();
  EXPECT_GT(once, 200);
  EXPECT_GT(light(), once) << "halo and the ground of the label";
  const int lightOnce = light();
  widget->SetPixelRatio(2);
  EXPECT_GT(accent(), 1.5 * once);
  EXPECT_GT(light(), 2 * lightOnce);
  window().SetDPI(144);
  EXPECT_GT(light(), 2 * lightOnce);
  EXPECT_LT(light(), 6 * lightOnce) << "letters are not scaled twice";
  renderer().GetActiveCamera()->SetPosition(2, 1.5, -3);
  renderer().GetActiveCamera()->SetFocalPoint(2, 1.5, -5);
  EXPECT_EQ(accent(), 0) << "behind the eye";
  renderer().ResetCamera();
  EXPECT_GT(accent(), 0);
  widget->SetEnabled(0);
  EXPECT_EQ(accent(), 0);
  EXPECT_EQ(light(), 0);
}

}  // namespace
}  // namespace holdfast
