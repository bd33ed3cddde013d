#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkEvent.h>
#include <vtkHandleWidget.h>
#include <vtkInteractorStyle.h>
#include <vtkObjectFactory.h>
#include <vtkPointHandleRepresentation2D.h>
#include <vtkPropCollection.h>
#include <vtkRenderWindow.h>
#include <vtkWidgetEventTranslator.h>

#include <holdfast/widgets/interaction/interaction_events.h>
#include <holdfast/widgets/interaction/vtkHoldfastSurfaceCameraStyle.h>

#include "holdfast/widgets/interaction/vtkHoldfastSurfacePointWidget.h"
#include "interaction/call_data_log.h"
#include "interaction/interaction_fixture.h"
#include "interaction/recorded_gesture.h"
#include "support/meshes.h"

namespace holdfast {
namespace {

using test::CallDataLog;
using test::InteractionFixture;
using testing::ElementsAre;
using testing::IsEmpty;

/// Turns from the press on, as styles of VTK do.
class TurningStyle : public vtkInteractorStyle {
 public:
  static TurningStyle* New();
  vtkTypeMacro(TurningStyle, vtkInteractorStyle)
  void OnLeftButtonDown() override { StartRotate(); }
  void OnLeftButtonUp() override { EndRotate(); }
  void OnRightButtonDown() override { StartDolly(); }
  void OnRightButtonUp() override { EndDolly(); }
};

vtkStandardNewMacro(TurningStyle);

struct PointWidgetFixture : InteractionFixture {
  explicit PointWidgetFixture(Mesh mesh) : InteractionFixture(std::move(mesh))
  {
    widget->SetSurface(surface());
    enable(*widget);
  }

  /// Inside of the triangle below the diagonal of the square with this lower left vertex.
  [[nodiscard]] DisplayPoint inFace(double x, double y) const { return pixelOf({x + 0.65, y + 0.35, 0}); }

  vtkNew<vtkHoldfastSurfacePointWidget> widget;
  CallDataLog<SurfacePick> shown{*widget, vtkCommand::InteractionEvent};
  CallDataLog<SurfacePick> placed{*widget, vtkCommand::PlacePointEvent};
  CallDataLog<PickKind> kinds{*widget, vtkCommand::WidgetValueChangedEvent};
};

struct PointWidgetOnGrid : PointWidgetFixture, testing::Test {
  PointWidgetOnGrid() : PointWidgetFixture(test::grid(4, 3)) {}
};

Index vertexOf(const std::optional<SurfacePick>& pick)
{
  const AtVertex* const at = pick ? std::get_if<AtVertex>(&pick->location) : nullptr;
  return at ? at->vertex : -1;
}

std::vector<Index> verticesOf(const std::vector<std::optional<SurfacePick>>& picks)
{
  std::vector<Index> vertices;
  for (const auto& pick : picks) vertices.push_back(vertexOf(pick));
  return vertices;
}

TEST_F(PointWidgetOnGrid, ShowsWhatAClickWouldTakeAndTakesIt)
{
  mouse().moveTo(pixelOfVertex(6));
  ASSERT_TRUE(widget->GetPreview());
  EXPECT_EQ(widget->GetPreview()->place, Vector3(1, 1, 0));
  EXPECT_THAT(placed.data(), IsEmpty());
  mouse().click(pixelOfVertex(7));
  EXPECT_THAT(verticesOf(shown.data()), ElementsAre(6, 7));
  EXPECT_THAT(verticesOf(placed.data()), ElementsAre(7));
}

TEST_F(PointWidgetOnGrid, GoesWithTheCursor)
{
  mouse().moveTo(pixelOfVertex(6));
  mouse().moveTo({1, 1});
  EXPECT_FALSE(widget->GetPreview());
  mouse().moveTo({2, 1});
  mouse().moveTo(pixelOfVertex(6));
  mouse().leave();
  EXPECT_FALSE(widget->GetPreview());
  ASSERT_EQ(shown.data().size(), 4U) << "nothing is said where nothing changes";
  EXPECT_FALSE(shown.data()[1]);
  EXPECT_FALSE(shown.data()[3]);
  mouse().click({1, 1});
  EXPECT_THAT(placed.data(), IsEmpty()) << "beside the surface";
}

TEST_F(PointWidgetOnGrid, ADragIsNoClickAndBelongsToTheCamera)
{
  vtkNew<vtkHoldfastSurfaceCameraStyle> style;
  interactor().SetInteractorStyle(style);
  const DisplayPoint from = pixelOfVertex(6);
  const Vector3 before(renderer().GetActiveCamera()->GetPosition());
  mouse().drag({from, from + DisplayPoint(3, 0), from + DisplayPoint(9, 0), from + DisplayPoint(15, 0)});
  EXPECT_NE(Vector3(renderer().GetActiveCamera()->GetPosition()), before);
  EXPECT_FALSE(widget->GetPreview()) << "nothing is shown while the camera moves";
  mouse().drag({from, from + DisplayPoint(9, 0), from});
  EXPECT_THAT(placed.data(), IsEmpty());
  const DisplayPoint at = pixelOfVertex(7);
  mouse().drag({at, at + DisplayPoint(2, 1)});
  EXPECT_THAT(verticesOf(placed.data()), ElementsAre(7)) << "a hand that trembles clicks";
  const Vector3 after(renderer().GetActiveCamera()->GetPosition());
  mouse().moveTo({20, 20});
  EXPECT_EQ(Vector3(renderer().GetActiveCamera()->GetPosition()), after) << "the style has seen the release";
}

TEST_F(PointWidgetOnGrid, ClicksBesideAStyleThatTurnsAtOnce)
{
  vtkNew<TurningStyle> style;
  interactor().SetInteractorStyle(style);
  mouse().click(pixelOfVertex(7));
  EXPECT_THAT(verticesOf(placed.data()), ElementsAre(7));
  mouse().moveTo(pixelOfVertex(6));
  mouse().wheel(pixelOfVertex(6), 1);
  EXPECT_FALSE(widget->GetPreview()) << "the camera has moved";
  mouse().rightPress(pixelOfVertex(7));
  mouse().moveTo(pixelOfVertex(7));
  EXPECT_FALSE(widget->GetPreview());
  mouse().rightRelease(pixelOfVertex(7));
  mouse().moveTo(pixelOfVertex(7));
  EXPECT_TRUE(widget->GetPreview());
}

TEST_F(PointWidgetOnGrid, ADoubleClickPlacesOnePoint)
{
  mouse().doubleClick(pixelOfVertex(6));
  EXPECT_EQ(placed.data().size(), 1U);
}

TEST_F(PointWidgetOnGrid, KeysChooseWhatPointsLieOn)
{
  const DisplayPoint cursor = inFace(1, 1);
  mouse().moveTo(cursor);
  EXPECT_TRUE(std::holds_alternative<AtFace>(widget->GetPreview()->location));
  mouse().type("v");
  EXPECT_TRUE(std::holds_alternative<AtVertex>(widget->GetPreview()->location)) << "at once, without a move";
  mouse().type("e");
  EXPECT_TRUE(std::holds_alternative<AtEdge>(widget->GetPreview()->location));
  mouse().moveTo(pixelOfVertex(6));
  mouse().type("f");
  EXPECT_TRUE(std::holds_alternative<AtFace>(widget->GetPreview()->location));
  mouse().type("aa");
  EXPECT_TRUE(std::holds_alternative<AtVertex>(widget->GetPreview()->location));
  EXPECT_THAT(kinds.data(), ElementsAre(PickKind::Vertex, PickKind::Edge, PickKind::Face, PickKind::Nearest));
  mouse().key("v", {.ctrl = true});
  EXPECT_EQ(widget->GetKind(), PickKind::Nearest) << "a shortcut of the window";
}

TEST_F(PointWidgetOnGrid, KeysThatAreUsedStayWithTheWidget)
{
  vtkNew<TurningStyle> style;
  interactor().SetInteractorStyle(style);
  const test::EventLog exits(interactor(), {vtkCommand::ExitEvent});
  mouse().type("e");
  EXPECT_THAT(exits.events(), IsEmpty()) << "VTK's styles quit with this key";
  EXPECT_EQ(widget->GetKind(), PickKind::Edge);
}

TEST_F(PointWidgetOnGrid, BindingsCanBeChanged)
{
  EXPECT_TRUE(widget->WantsKey('v'));
  EXPECT_FALSE(widget->WantsKey('k'));
  vtkWidgetEventTranslator& translator = *widget->GetEventTranslator();
  translator.RemoveTranslation(vtkCommand::CharEvent, vtkEvent::NoModifier, 'v', 0, nullptr);
  translator.SetTranslation(vtkCommand::CharEvent, vtkEvent::NoModifier, 'k', 0, nullptr,
                            vtkHoldfastSurfacePointWidget::ChooseVertices);
  translator.RemoveTranslation(vtkCommand::LeftButtonReleaseEvent);
  EXPECT_FALSE(widget->WantsKey('v'));
  EXPECT_TRUE(widget->WantsKey('k'));
  mouse().type("v");
  EXPECT_EQ(widget->GetKind(), PickKind::Nearest);
  mouse().type("k");
  EXPECT_EQ(widget->GetKind(), PickKind::Vertex);
  mouse().click(pixelOfVertex(6));
  EXPECT_THAT(placed.data(), IsEmpty());
}

TEST_F(PointWidgetOnGrid, AfterADeformationThePointIsAtTheSameLocation)
{
  mouse().moveTo(inFace(1, 1));
  const SurfacePick before = *widget->GetPreview();
  const auto moved = std::make_shared<Positions>(2 * model().mesh.positions);
  widget->SetSurface(std::make_shared<const VisibleSurface>(surface()->movedTo(moved)));
  ASSERT_TRUE(widget->GetPreview());
  EXPECT_LE((widget->GetPreview()->place - 2 * before.place).norm(), 1e-14);
  widget->SetSurface(std::make_shared<const VisibleSurface>(model()));
  EXPECT_FALSE(widget->GetPreview()) << "another mesh, for all that is known";
  widget->SetSurface(nullptr);
  mouse().click(pixelOfVertex(6));
  EXPECT_THAT(placed.data(), IsEmpty());
}

TEST_F(PointWidgetOnGrid, IsSetFromOutsideWithoutEvents)
{
  SurfacePick pick;
  pick.location = AtVertex{6};
  widget->SetPreview(&pick);
  EXPECT_EQ(widget->GetPreview()->place, Vector3(1, 1, 0));
  widget->HidePreview();
  EXPECT_FALSE(widget->GetPreview());
  EXPECT_THAT(shown.data(), IsEmpty());
}

TEST_F(PointWidgetOnGrid, DisabledItShowsAndTakesNothing)
{
  mouse().moveTo(pixelOfVertex(6));
  mouse().press(pixelOfVertex(6));
  widget->SetEnabled(0);
  EXPECT_FALSE(widget->GetPreview());
  EXPECT_FALSE(shown.data().back());
  EXPECT_FALSE(renderer().HasViewProp(widget->GetRepresentation()));
  mouse().release(pixelOfVertex(6));
  mouse().click(pixelOfVertex(6));
  enable(*widget);
  mouse().release(pixelOfVertex(6));
  EXPECT_THAT(placed.data(), IsEmpty()) << "the press came before it was disabled";
  mouse().click(pixelOfVertex(6));
  EXPECT_EQ(placed.data().size(), 1U);
}

TEST_F(PointWidgetOnGrid, ActsInItsRendererAlone)
{
  renderer().SetViewport(0, 0, 0.5, 1);
  vtkNew<vtkRenderer> other;
  other->SetViewport(0.5, 0, 1, 1);
  other->SetActiveCamera(renderer().GetActiveCamera());
  window().AddRenderer(other);
  // Its part of the window cuts the surface off.
  renderer().GetActiveCamera()->Zoom(3);
  const DisplayPoint inside = pixelOfVertex(7);
  ASSERT_LT(inside.x(), 200);
  mouse().click(inside + DisplayPoint(200, 0));
  EXPECT_THAT(shown.data(), IsEmpty());
  EXPECT_THAT(placed.data(), IsEmpty());
  mouse().click(inside);
  EXPECT_THAT(verticesOf(placed.data()), ElementsAre(7));
  mouse().moveTo(inside + DisplayPoint(200, 0));
  EXPECT_FALSE(widget->GetPreview());
}

TEST_F(PointWidgetOnGrid, ReachesFartherOnADisplayOfManyPixels)
{
  const DisplayPoint beside = pixelOfVertex(6) + DisplayPoint(10, 5);
  mouse().moveTo(beside);
  EXPECT_FALSE(widget->GetPreview() && std::holds_alternative<AtVertex>(widget->GetPreview()->location));
  widget->SetPixelRatio(2);
  mouse().drag({beside, beside + DisplayPoint(6, 0), beside});
  EXPECT_THAT(verticesOf(placed.data()), ElementsAre(6)) << "6 of its pixels are 3";
  EXPECT_EQ(widget->GetSurfacePointRepresentation()->GetPixelRatio(), 2);
}

TEST_F(PointWidgetOnGrid, LeavesToAWidgetOfVTKAboveItWhatThatUses)
{
  vtkNew<vtkPointHandleRepresentation2D> cross;
  vtkNew<vtkHandleWidget> handle;
  handle->SetRepresentation(cross);
  handle->SetInteractor(&interactor());
  handle->SetCurrentRenderer(&renderer());
  handle->SetPriority(0.6F);
  handle->SetEnabled(1);
  double place[3] = {1, 1, 0};
  cross->SetWorldPosition(place);
  window().Render();
  const test::EventLog grabbed(*handle, {vtkCommand::StartInteractionEvent});
  mouse().click(pixelOfVertex(6));
  EXPECT_EQ(grabbed.events().size(), 1U);
  EXPECT_THAT(placed.data(), IsEmpty()) << "the press was aborted above";
  mouse().click(pixelOfVertex(7));
  EXPECT_EQ(placed.data().size(), 1U);
}

TEST_F(PointWidgetOnGrid, CanBeEnabledBeforeThereIsASurface)
{
  vtkNew<vtkHoldfastSurfacePointWidget> early;
  early->SetInteractor(&interactor());
  early->SetEnabled(1);
  const CallDataLog<SurfacePick> taken(*early, vtkCommand::PlacePointEvent);
  mouse().click(pixelOfVertex(7));
  EXPECT_THAT(taken.data(), IsEmpty());
  early->SetSurface(surface());
  mouse().click(pixelOfVertex(7));
  EXPECT_EQ(taken.data().size(), 1U);
}

TEST_F(PointWidgetOnGrid, AReplayedGestureDoesTheSame)
{
  const std::string events = test::recorded(interactor(), [&] {
    mouse().moveTo(inFace(1, 1));
    mouse().type("v");
    mouse().click(inFace(1, 1));
  });
  PointWidgetFixture again(test::grid(4, 3));
  test::replay(events, again.interactor());
  ASSERT_EQ(placed.data().size(), 1U);
  EXPECT_GE(vertexOf(placed.data()[0]), 0);
  EXPECT_EQ(verticesOf(again.placed.data()), verticesOf(placed.data()));
  EXPECT_EQ(verticesOf(again.shown.data()), verticesOf(shown.data()));
}

TEST_F(PointWidgetOnGrid, GivesItsActors)
{
  vtkNew<vtkPropCollection> actors;
  widget->GetRepresentation()->GetActors(actors);
  EXPECT_GT(actors->GetNumberOfItems(), 3);
}

}  // namespace
}  // namespace holdfast
