#include "holdfast/view/interaction/surface_curve_widget.h"

#include <algorithm>
#include <set>
#include <sstream>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkHandleWidget.h>
#include <vtkInteractorEventRecorder.h>
#include <vtkPointHandleRepresentation3D.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkRenderWindow.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWidgetEvent.h>
#include <vtkWidgetEventTranslator.h>

#include <holdfast/constraints/curve_selector.h>
#include <holdfast/io/mesh_file.h>
#include <holdfast/surface/curve_region.h>
#include <holdfast/view/interaction/interaction_events.h>
#include <holdfast/view/interaction/surface_camera_style.h>
#include <holdfast/view/interaction/surface_curve_representation.h>

#include "interaction/interaction_stage.h"
#include "support/law_meshes.h"
#include "support/meshes.h"
#include "support/plain_curve.h"
#include "support/source_tree.h"
#include "support/temporary_folder.h"

namespace holdfast {
namespace {

using test::EventLog;
using test::Hand;
using test::InteractionStage;
using testing::Contains;
using testing::ElementsAre;
using testing::Gt;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Lt;
using testing::Not;
using testing::SizeIs;

constexpr unsigned long kCurveBegins = vtkCommand::StartInteractionEvent;
constexpr unsigned long kCurvePlaced = vtkCommand::PlacePointEvent;
constexpr unsigned long kCurveDragged = vtkCommand::InteractionEvent;
constexpr unsigned long kCurveChanged = vtkCommand::WidgetValueChangedEvent;
constexpr unsigned long kCurveEnds = vtkCommand::EndInteractionEvent;
constexpr unsigned long kCurveCancelled = CancelInteractionEvent;

/// A window with a curve widget.
class DrawnCurve {
 public:
  explicit DrawnCurve(Mesh mesh, int width = 400, int height = 300) : stage(std::move(mesh), width, height)
  {
    widget->SetInteractor(&stage.interactor());
    widget->SetCurrentRenderer(&stage.renderer());
    widget->SetSurface(stage.surface());
    widget->SetRegions(std::make_shared<VertexRegions>(stage.model().mesh, stage.model().solverMesh));
    for (const unsigned long event :
         {kCurveBegins, kCurvePlaced, kCurveDragged, kCurveChanged, kCurveEnds, kCurveCancelled})
      widget->AddObserver(event, this, &DrawnCurve::hear);
    widget->On();
  }

  void hear(vtkObject* /*widget*/, unsigned long event, void* callData)
  {
    events.push_back(event);
    if (event == kCurvePlaced)
      placed.push_back(*static_cast<Index*>(callData));
    else
      told = *static_cast<std::vector<Index>*>(callData);
  }

  [[nodiscard]] Hand& hand() { return stage.hand(); }
  [[nodiscard]] SurfaceCurveRepresentation& curve() { return *widget->GetSurfaceCurveRepresentation(); }
  void click(Index vertex) { hand().click(stage.pixelOfVertex(vertex)); }
  void click(const std::vector<Index>& vertices)
  {
    for (const Index vertex : vertices) click(vertex);
  }

  InteractionStage stage;
  vtkNew<SurfaceCurveWidget> widget;
  std::vector<unsigned long> events;
  std::vector<Index> placed;
  std::vector<Index> told;
};

/// Vertex (i, j) of the grid is 11 j + i.
struct CurveOnGrid : testing::Test, DrawnCurve {
  CurveOnGrid() : DrawnCurve(test::grid(10, 8)) {}

  [[nodiscard]] std::vector<Index> closedThrough(const std::vector<Index>& places)
  {
    return closedCurve(EdgeGraph(stage.model().solverMesh), places);
  }
};

TEST_F(CurveOnGrid, ClicksPlaceVerticesThatShortestPathsJoin)
{
  click({24, 29});
  EXPECT_THAT(widget->GetPlaces(), ElementsAre(24, 29));
  EXPECT_THAT(widget->GetPath(), ElementsAre(24, 25, 26, 27, 28, 29));
  EXPECT_THAT(events, ElementsAre(kCurveBegins, kCurvePlaced, kCurveChanged, kCurvePlaced, kCurveChanged));
  EXPECT_THAT(placed, ElementsAre(24, 29));
  EXPECT_THAT(told, ElementsAre(24, 29));
  EXPECT_EQ(widget->GetWidgetState(), vtkContourWidget::Define);
}

TEST_F(CurveOnGrid, AClickOnTheFirstPlaceCloses)
{
  click({24, 29, 73});
  events.clear();
  hand().click(stage.pixelOfVertex(24) + DisplayPoint(7, 7));
  EXPECT_THAT(events, ElementsAre(kCurveChanged, kCurveEnds));
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
    hand().key(key);
    EXPECT_FALSE(widget->IsClosed()) << "two places enclose nothing";
    click(73);
    hand().key(key);
    EXPECT_TRUE(widget->IsClosed());
    EXPECT_THAT(events, Contains(kCurveEnds).Times(1));
  }
  widget->Clear();
  events.clear();
  click({24, 29});
  hand().doubleClick(stage.pixelOfVertex(73));
  EXPECT_TRUE(widget->IsClosed());
  EXPECT_THAT(widget->GetPlaces(), ElementsAre(24, 29, 73));
  EXPECT_THAT(events, Contains(kCurveEnds).Times(1));
  widget->Clear();
  click({24, 29, 73});
  stage.interactor().InvokeEvent(vtkCommand::LeftButtonDoubleClickEvent);
  EXPECT_TRUE(widget->IsClosed());
}

TEST_F(CurveOnGrid, BackspaceTakesTheLastPlaceBack)
{
  click({24, 29, 73});
  events.clear();
  hand().key("BackSpace");
  EXPECT_THAT(widget->GetPlaces(), ElementsAre(24, 29));
  EXPECT_THAT(widget->GetPath(), ElementsAre(24, 25, 26, 27, 28, 29));
  hand().key("Delete");
  hand().key("BackSpace");
  EXPECT_THAT(widget->GetPlaces(), IsEmpty());
  EXPECT_EQ(widget->GetWidgetState(), vtkContourWidget::Start);
  EXPECT_THAT(events, ElementsAre(kCurveChanged, kCurveChanged, kCurveChanged));
  hand().key("BackSpace");
  EXPECT_THAT(events, SizeIs(3));
}

TEST_F(CurveOnGrid, EscapeTakesAllPlacesBack)
{
  click({24, 29, 73});
  events.clear();
  hand().key("Escape");
  EXPECT_THAT(widget->GetPlaces(), IsEmpty());
  EXPECT_THAT(events, ElementsAre(kCurveCancelled));
  EXPECT_THAT(told, IsEmpty());
  hand().key("Escape");
  EXPECT_THAT(events, SizeIs(1));
}

TEST_F(CurveOnGrid, KeysThatAreNotUsedGoOn)
{
  EventLog keys(stage.interactor(), {vtkCommand::KeyPressEvent});
  for (const char* const key : {"Escape", "BackSpace", "Return"}) hand().key(key);
  EXPECT_THAT(keys.events(), SizeIs(3));
  click({24, 29, 73});
  for (const char* const key : {"Return", "BackSpace", "Escape"}) hand().key(key);
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
  vtkNew<SurfaceCameraStyle> style;
  stage.interactor().SetInteractorStyle(style);
  const Vector3 eye(stage.renderer().GetActiveCamera()->GetPosition());
  const DisplayPoint at = stage.pixelOfVertex(24);
  hand().drag({at, at + DisplayPoint(40, 10), at});
  EXPECT_THAT(events, IsEmpty());
  EXPECT_EQ(style->GetState(), VTKIS_NONE) << "the release reached the style";
  hand().drag({at, at + DisplayPoint(40, 10)});
  EXPECT_NE(Vector3(stage.renderer().GetActiveCamera()->GetPosition()), eye);
  EXPECT_THAT(events, IsEmpty());
  hand().drag({stage.pixelOfVertex(29), stage.pixelOfVertex(29) + DisplayPoint(2, 2)});
  EXPECT_THAT(widget->GetPlaces(), ElementsAre(29));
  widget->SetPixelRatio(2);
  hand().drag({stage.pixelOfVertex(73), stage.pixelOfVertex(73) + DisplayPoint(0, 5)});
  EXPECT_THAT(widget->GetPlaces(), ElementsAre(29, 73));
}

TEST_F(CurveOnGrid, TheWayToTheCursorIsShown)
{
  hand().moveTo(stage.pixelOfVertex(24));
  EXPECT_THAT(curve().GetPreview(), ElementsAre(24));
  click(24);
  EXPECT_THAT(curve().GetPreview(), IsEmpty());
  hand().moveTo(stage.pixelOfVertex(28));
  EXPECT_THAT(curve().GetPreview(), ElementsAre(24, 25, 26, 27, 28));
  EXPECT_THAT(widget->GetPlaces(), ElementsAre(24));
  hand().leave();
  EXPECT_THAT(curve().GetPreview(), IsEmpty());
  click({28, 72});
  hand().moveTo(stage.pixelOfVertex(24) + DisplayPoint(8, 6));
  EXPECT_EQ(curve().GetPreview().back(), 24);
  EXPECT_EQ(stage.window().GetCurrentCursor(), VTK_CURSOR_HAND);
  hand().moveTo(stage.pixelOfVertex(40));
  EXPECT_EQ(stage.window().GetCurrentCursor(), VTK_CURSOR_CROSSHAIR);
  hand().key("Return");
  EXPECT_THAT(curve().GetPreview(), IsEmpty());
  widget->Clear();
  widget->FollowCursorOff();
  hand().moveTo(stage.pixelOfVertex(24));
  EXPECT_THAT(curve().GetPreview(), IsEmpty());
}

TEST_F(CurveOnGrid, HoveringWaitsWhileTheCameraMoves)
{
  vtkNew<SurfaceCameraStyle> style;
  stage.interactor().SetInteractorStyle(style);
  hand().press({3, 3});
  // The style begins with this one, which it sees after the widget.
  hand().moveTo({10, 3});
  hand().moveTo(stage.pixelOfVertex(24));
  EXPECT_THAT(curve().GetPreview(), IsEmpty());
  hand().release(stage.pixelOfVertex(24));
}

TEST_F(CurveOnGrid, PlacesOfAClosedCurveCanBeDragged)
{
  click({24, 29, 73});
  hand().key("Return");
  events.clear();
  hand().drag({stage.pixelOfVertex(29), stage.pixelOfVertex(30), stage.pixelOfVertex(41)});
  EXPECT_THAT(widget->GetPlaces(), ElementsAre(24, 41, 73));
  EXPECT_EQ(widget->GetPath(), closedThrough({24, 41, 73}));
  EXPECT_THAT(events,
              ElementsAre(kCurveBegins, kCurveDragged, kCurveChanged, kCurveDragged, kCurveChanged, kCurveEnds));
  EXPECT_THAT(told, ElementsAre(24, 41, 73));
}

TEST_F(CurveOnGrid, ADragFromTheLineOfAClosedCurvePutsOneMorePlace)
{
  click({24, 29, 73});
  hand().key("Return");
  events.clear();
  hand().drag({stage.pixelOfVertex(27), stage.pixelOfVertex(16)});
  EXPECT_THAT(widget->GetPlaces(), ElementsAre(24, 16, 29, 73));
  EXPECT_THAT(events, ElementsAre(kCurveBegins, kCurveChanged, kCurveDragged, kCurveChanged, kCurveEnds));
  // Beside the line nothing happens.
  events.clear();
  hand().drag({stage.pixelOfVertex(90), stage.pixelOfVertex(92)});
  EXPECT_THAT(events, IsEmpty());
}

TEST_F(CurveOnGrid, ADragIsTakenBackByEscapeAndWhereTheWidgetGoes)
{
  click({24, 29, 73});
  hand().key("Return");
  for (const bool byKey : {true, false}) {
    events.clear();
    hand().press(stage.pixelOfVertex(27));
    hand().moveTo(stage.pixelOfVertex(16));
    byKey ? hand().key("Escape") : widget->Off();
    EXPECT_THAT(widget->GetPlaces(), ElementsAre(24, 29, 73));
    EXPECT_TRUE(widget->IsClosed());
    EXPECT_EQ(events.back(), kCurveCancelled);
    const std::size_t count = events.size();
    hand().moveTo(stage.pixelOfVertex(17));
    hand().release(stage.pixelOfVertex(17));
    EXPECT_THAT(events, SizeIs(count));
  }
}

TEST_F(CurveOnGrid, BackspaceTakesThePlaceUnderTheCursorFromAClosedCurve)
{
  click({24, 29, 62, 57});
  hand().key("Return");
  hand().moveTo(stage.pixelOfVertex(29));
  EXPECT_EQ(stage.window().GetCurrentCursor(), VTK_CURSOR_HAND);
  hand().key("BackSpace");
  EXPECT_THAT(widget->GetPlaces(), ElementsAre(24, 62, 57));
  EXPECT_EQ(widget->GetPath(), closedThrough({24, 62, 57}));
  EXPECT_TRUE(widget->IsClosed());
  hand().key("BackSpace");
  EXPECT_THAT(widget->GetPlaces(), ElementsAre(24, 62));
  EXPECT_FALSE(widget->IsClosed());
  EXPECT_EQ(widget->GetWidgetState(), vtkContourWidget::Define);
}

TEST_F(CurveOnGrid, ProgramsSetCloseAndClear)
{
  EXPECT_TRUE(widget->SetPlaces({24, 29, 73}));
  EXPECT_THAT(widget->GetPlaces(), ElementsAre(24, 29, 73));
  widget->CloseLoop();
  EXPECT_EQ(widget->GetPath(), closedThrough({24, 29, 73}));
  EXPECT_TRUE(widget->SetPlaces({24, 29}));
  EXPECT_FALSE(widget->IsClosed());
  EXPECT_FALSE(widget->SetPlaces({24, 29, 24}));
  EXPECT_THAT(widget->GetPlaces(), IsEmpty());
  widget->SetPlaces({24, 29, 73});
  widget->Clear();
  EXPECT_THAT(widget->GetPath(), IsEmpty());
  EXPECT_THAT(events, IsEmpty());

  EXPECT_TRUE(widget->AddPlace(24) && widget->AddPlace(29) && !widget->Close() && widget->AddPlace(73));
  EXPECT_TRUE(widget->Close());
  EXPECT_EQ(events.back(), kCurveEnds);
  EXPECT_FALSE(widget->Close());
  EXPECT_FALSE(widget->AddPlace(40));
  EXPECT_TRUE(widget->RemoveLast());
  EXPECT_FALSE(widget->IsClosed());
  EXPECT_TRUE(widget->Cancel());
  EXPECT_FALSE(widget->Cancel());
  EXPECT_FALSE(widget->RemoveLast());
}

TEST_F(CurveOnGrid, PlacesNeedNoWindow)
{
  vtkNew<SurfaceCurveWidget> apart;
  EXPECT_FALSE(apart->SetPlaces({24, 29, 73}));
  apart->SetSurface(stage.surface());
  EXPECT_FALSE(apart->SetPlaces({24, 29, 73}));
  apart->SetRegions(std::make_shared<VertexRegions>(stage.model().mesh, stage.model().solverMesh));
  EXPECT_TRUE(apart->SetPlaces({24, 29, 73}));
  EXPECT_TRUE(apart->Close());
  EXPECT_EQ(apart->GetPath(), closedThrough({24, 29, 73}));
  EXPECT_FALSE(apart->GetSurfaceCurveRepresentation()->VertexAt({200, 150}));
}

TEST_F(CurveOnGrid, VtksWaysToNodesKeepToVertices)
{
  EXPECT_EQ(curve().AddNodeAtWorldPosition(2.2, 1.9, 0.3), 1);
  DisplayPoint pixel = stage.pixelOfVertex(29);
  EXPECT_EQ(curve().AddNodeAtDisplayPosition(pixel.data()), 1);
  EXPECT_EQ(curve().AddNodeAtDisplayPosition(static_cast<int>(pixel.x()), static_cast<int>(pixel.y())), 0);
  EXPECT_EQ(curve().AddNodeAtWorldPosition(7.1, 6, 0), 1);
  EXPECT_THAT(widget->GetPlaces(), ElementsAre(24, 29, 73));
  double place[3] = {7, 5, 0};
  EXPECT_EQ(curve().SetNthNodeWorldPosition(1, place), 1);
  pixel = stage.pixelOfVertex(72);
  EXPECT_EQ(curve().SetNthNodeDisplayPosition(2, pixel.data()), 1);
  EXPECT_EQ(curve().SetNthNodeDisplayPosition(3, pixel.data()), 0);
  EXPECT_THAT(widget->GetPlaces(), ElementsAre(24, 62, 72));
  pixel = stage.pixelOfVertex(62);
  ASSERT_EQ(curve().ActivateNode(pixel.data()), 1);
  double other[3] = {6, 4, 0};
  EXPECT_EQ(curve().SetActiveNodeToWorldPosition(other), 1);
  EXPECT_THAT(widget->GetPlaces(), ElementsAre(24, 50, 72));
  EXPECT_EQ(curve().DeleteNthNode(1), 1);
  EXPECT_THAT(widget->GetPath(), ElementsAre(24, 36, 48, 60, 72));
  EXPECT_EQ(curve().GetContourRepresentationAsPolyData()->GetNumberOfPoints(), 5);
}

TEST_F(CurveOnGrid, InitializesFromAPolyline)
{
  vtkNew<vtkPolyData> line;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  points->InsertNextPoint(2.1, 2, 0);
  points->InsertNextPoint(7, 2.2, 0);
  points->InsertNextPoint(7, 6, 0.1);
  cells->InsertNextCell({0, 1, 2, 0});
  line->SetPoints(points);
  line->SetLines(cells);
  widget->Initialize(line);
  EXPECT_EQ(widget->GetPath(), closedThrough({24, 29, 73}));
  EXPECT_EQ(widget->GetWidgetState(), vtkContourWidget::Manipulate);
  widget->Initialize();
  EXPECT_THAT(widget->GetPlaces(), IsEmpty());
  click({24, 29});
  EXPECT_THAT(widget->GetPlaces(), ElementsAre(24, 29));
}

TEST_F(CurveOnGrid, FollowsTheSurface)
{
  click({24, 29, 73});
  hand().key("Return");
  auto moved = std::make_shared<Positions>(stage.surface()->positions());
  moved->col(2).array() += 0.25;
  widget->SetSurface(std::make_shared<const VisibleSurface>(stage.surface()->movedTo(moved)));
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
  hand().press(stage.pixelOfVertex(73));
  widget->Off();
  hand().release(stage.pixelOfVertex(73));
  EXPECT_THAT(widget->GetPlaces(), ElementsAre(24, 29));
  EXPECT_EQ(stage.window().GetCurrentCursor(), VTK_CURSOR_DEFAULT);
  widget->SetCurrentRenderer(&stage.renderer());
  widget->On();
  hand().release(stage.pixelOfVertex(73));
  EXPECT_THAT(widget->GetPlaces(), ElementsAre(24, 29));
  click(73);
  EXPECT_THAT(widget->GetPlaces(), ElementsAre(24, 29, 73));
}

TEST_F(CurveOnGrid, ObserversMayTakeAllAwayAtAnyEvent)
{
  for (const unsigned long event : {kCurveBegins, kCurvePlaced, kCurveChanged, kCurveDragged, kCurveEnds}) {
    const unsigned long tag = widget->AddObserver(event, widget.Get(), &SurfaceCurveWidget::Clear);
    click({24, 29, 73});
    hand().key("Return");
    hand().drag({stage.pixelOfVertex(29), stage.pixelOfVertex(30), stage.pixelOfVertex(41)});
    widget->RemoveObserver(tag);
    click({24, 29, 73});
    EXPECT_THAT(widget->GetPlaces(), ElementsAre(24, 29, 73));
    widget->Clear();
  }
}

TEST_F(CurveOnGrid, OtherRenderersKeepTheirEvents)
{
  vtkNew<vtkRenderer> other;
  stage.renderer().SetViewport(0, 0, 0.5, 1);
  other->SetViewport(0.5, 0, 1, 1);
  stage.window().AddRenderer(other);
  hand().click({300, 150});
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
  handle->SetInteractor(&stage.interactor());
  handle->SetCurrentRenderer(&stage.renderer());
  ball->PlaceWidget(stage.renderer().ComputeVisiblePropBounds());
  double place[3] = {7, 2, 0};
  ball->SetWorldPosition(place);
  handle->On();
  widget->SetPlaces({24, 29, 73});
  widget->CloseLoop();
  widget->SetPriority(0.6F);
  hand().drag({stage.pixelOfVertex(29), stage.pixelOfVertex(30)});
  EXPECT_THAT(widget->GetPlaces(), ElementsAre(24, 30, 73));
  EXPECT_EQ(Vector3(ball->GetWorldPosition()), Vector3(7, 2, 0));
  widget->SetPlaces({24, 29, 73});
  widget->CloseLoop();
  widget->SetPriority(0.4F);
  hand().drag({stage.pixelOfVertex(29), stage.pixelOfVertex(30)});
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
  widget->SetCurrentRenderer(&stage.renderer());
  widget->On();
  click({24, 29, 73});
  EXPECT_THAT(events, IsEmpty());
  for (const Index vertex : {24, 29, 73}) {
    hand().rightPress(stage.pixelOfVertex(vertex));
    hand().rightRelease(stage.pixelOfVertex(vertex));
  }
  hand().middlePress({5, 5});
  EXPECT_THAT(widget->GetPlaces(), ElementsAre(24, 29, 73));
  EXPECT_TRUE(widget->IsClosed());
}

TEST_F(CurveOnGrid, ARecordedGestureDrawsTheSameAgain)
{
  const test::TemporaryFolder folder;
  const std::string path = (folder.path() / "curve.log").string();
  vtkNew<vtkInteractorEventRecorder> recorder;
  recorder->SetInteractor(&stage.interactor());
  recorder->SetFileName(path.c_str());
  recorder->On();
  recorder->Record();
  click({24, 29, 73});
  hand().key("Return");
  recorder->Stop();
  recorder->Off();
  const auto recorded = std::exchange(events, {});
  ASSERT_THAT(recorded, Contains(kCurveEnds));
  widget->Clear();

  vtkNew<vtkInteractorEventRecorder> player;
  player->SetInteractor(&stage.interactor());
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
  widget->Print(text);
  curve().Print(text);
  curve().GetLineInterpolator()->Print(text);
  EXPECT_THAT(text.str(),
              testing::AllOf(HasSubstr("Places: 24 29\n"), HasSubstr("IsDragging: No"), HasSubstr("Regions: 0x")));
}

TEST(CurveOnParts, PlacesOfAnotherPartAreRefused)
{
  DrawnCurve curve(test::merged(test::grid(4, 4), test::moved(test::grid(4, 4), {5, 0, 0})));
  curve.click({6, 8});
  curve.click(25 + 12);
  EXPECT_THAT(curve.widget->GetPlaces(), ElementsAre(6, 8));
  curve.hand().moveTo(curve.stage.pixelOfVertex(25 + 12));
  EXPECT_THAT(curve.curve().GetPreview(), IsEmpty());
  curve.click({18, 16});
  curve.hand().key("Return");
  // Nor can one be dragged there.
  curve.hand().drag({curve.stage.pixelOfVertex(8), curve.stage.pixelOfVertex(25 + 6)});
  EXPECT_THAT(curve.widget->GetPlaces(), ElementsAre(6, 8, 18, 16));
}

TEST(CurveOnSoup, PathsCrossFacesThatShareNoVertices)
{
  DrawnCurve curve(test::soup(test::grid(6, 6)));
  const Model& model = curve.stage.model();
  const auto vertexAt = [&](double x, double y) {
    Index nearest = 0;
    (model.mesh.positions.rowwise() - Vector3(x, y, 0).transpose()).rowwise().squaredNorm().minCoeff(&nearest);
    return nearest;
  };
  const std::vector<Index> corners{vertexAt(1, 1), vertexAt(5, 1), vertexAt(5, 5)};
  curve.click(corners);
  curve.hand().key("Return");
  ASSERT_TRUE(curve.widget->IsClosed());
  std::vector<Index> unknowns;
  for (const Index vertex : curve.widget->GetPath()) unknowns.push_back(model.solverMesh.weld.unknownOf[vertex]);
  std::vector<Index> expected;
  for (const Index vertex : corners) expected.push_back(model.solverMesh.weld.unknownOf[vertex]);
  EXPECT_EQ(unknowns, closedCurve(EdgeGraph(model.solverMesh), expected));
  // Corners at one place are one place.
  EXPECT_EQ(model.solverMesh.unknownCount(), 49);
  for (Index v = 0; v < model.mesh.vertexCount(); ++v) {
    if (model.mesh.positions.row(v) != model.mesh.positions.row(corners[0])) continue;
    EXPECT_FALSE(curve.curve().InsertPlace(3, v));
  }
}

/// The head from the front.
struct CurveOnHead : testing::Test, DrawnCurve {
  CurveOnHead() : DrawnCurve(readMesh(test::dataFolder() + "/head.ply").mesh, 640, 480)
  {
    vtkCamera& camera = *stage.renderer().GetActiveCamera();
    camera.SetPosition(0, -1, 0);
    camera.SetFocalPoint(0, 0, 0);
    camera.SetViewUp(0, 0, 1);
    stage.renderer().ResetCamera();
    camera.Zoom(1.7);
  }

  [[nodiscard]] std::vector<Index> aroundAnEye() const
  {
    std::vector<Index> places;
    for (const Vector3& place :
         {Vector3(41, -76, 25), Vector3(27, -76, 39), Vector3(13, -76, 25), Vector3(27, -76, 11)}) {
      Index nearest = 0;
      (stage.model().mesh.positions.rowwise() - place.transpose()).rowwise().squaredNorm().minCoeff(&nearest);
      places.push_back(nearest);
    }
    return places;
  }
};

TEST_F(CurveOnHead, ACurveAroundAnEyeEnclosesWhatItsConstraintWould)
{
  const std::vector<Index> places = aroundAnEye();
  click(places);
  hand().key("Return");
  ASSERT_EQ(told, places);
  nlohmann::json plain;
  InsideCurve inside;
  for (const Index vertex : told) {
    const Vector3 exact = stage.model().mesh.positions.row(vertex).transpose();
    plain["through"].push_back({{"near", {exact.x(), exact.y(), exact.z()}}});
    inside.through.push_back(AtVertex{vertex});
  }
  const Model& model = stage.model();
  SurfaceLocator locator(model.mesh, model.triangulation);
  const std::vector<Index> selected = CurveSelector(model.mesh, model.solverMesh, locator).select(inside, {});
  EXPECT_THAT(selected, SizeIs(Gt(10u)));
  EXPECT_EQ(std::set<long>(selected.begin(), selected.end()),
            test::insidePlain(plain, test::readPlainMesh(test::dataFolder() + "/head.ply")));
  for (const Index vertex : widget->GetPath()) EXPECT_THAT(selected, Contains(vertex));
}

/// How many of these places have a pixel beside them that is more red than blue by `difference`.
int countRed(vtkRenderWindow& window, const std::vector<DisplayPoint>& places, int difference)
{
  window.Render();
  const int width = window.GetSize()[0];
  vtkNew<vtkUnsignedCharArray> colors;
  window.GetPixelData(0, 0, width - 1, window.GetSize()[1] - 1, 0, colors);
  const auto isRed = [&](const DisplayPoint& place) {
    const vtkIdType pixel = 3 * (static_cast<vtkIdType>(place.y()) * width + static_cast<vtkIdType>(place.x()));
    return colors->GetValue(pixel) > colors->GetValue(pixel + 2) + difference;
  };
  return static_cast<int>(std::count_if(places.begin(), places.end(), [&](const DisplayPoint& place) {
    bool isAnyRed = false;
    for (int k = 0; k < 9; ++k) isAnyRed = isAnyRed || isRed(place + DisplayPoint(k % 3 - 1, k / 3 - 1));
    return isAnyRed;
  }));
}

constexpr int kSolidRed = 140;
constexpr int kFaintRed = 12;

TEST_F(CurveOnHead, NoneOfItSinksIntoTheSurface)
{
  click(aroundAnEye());
  hand().key("Return");
  for (const double degrees : {0.0, 20.0, -35.0}) {
    stage.renderer().GetActiveCamera()->Azimuth(degrees);
    std::vector<DisplayPoint> visible;
    for (const Index vertex : widget->GetPath())
      if (stage.surface()->isVertexVisible(vertex, DisplayTransform(stage.renderer())))
        visible.push_back(stage.pixelOfVertex(vertex));
    EXPECT_THAT(visible, SizeIs(Gt(20u)));
    EXPECT_EQ(countRed(stage.window(), visible, kSolidRed), static_cast<int>(visible.size())) << degrees;
  }
}

TEST_F(CurveOnHead, WhatLiesBehindIsFaint)
{
  click(aroundAnEye());
  hand().key("Return");
  const std::vector<int> orange{199, 61, 0};
  const int inFront = stage.countPixels(orange, 25);
  EXPECT_GT(inFront, 150);
  stage.renderer().GetActiveCamera()->Azimuth(180);
  stage.renderer().ResetCameraClippingRange();
  EXPECT_LT(stage.countPixels(orange, 25), inFront / 20);
  std::vector<DisplayPoint> hidden;
  for (const Index vertex : widget->GetPath()) hidden.push_back(stage.pixelOfVertex(vertex));
  EXPECT_EQ(countRed(stage.window(), hidden, kSolidRed), 0);
  EXPECT_EQ(countRed(stage.window(), hidden, kFaintRed), static_cast<int>(hidden.size()));
  widget->Off();
  EXPECT_EQ(countRed(stage.window(), hidden, kFaintRed), 0);
}

}  // namespace
}  // namespace holdfast
