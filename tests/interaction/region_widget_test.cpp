#include "holdfast/view/interaction/region_widget.h"

#include <cmath>
#include <sstream>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkGenericRenderWindowInteractor.h>
#include <vtkHandleWidget.h>
#include <vtkInteractorEventRecorder.h>
#include <vtkMatrix4x4.h>
#include <vtkPointHandleRepresentation3D.h>
#include <vtkRenderWindow.h>
#include <vtkWidgetEvent.h>
#include <vtkWidgetEventTranslator.h>

#include <holdfast/io/mesh_file.h>
#include <holdfast/view/interaction/interaction_events.h>
#include <holdfast/view/interaction/region_representation.h>
#include <holdfast/view/interaction/surface_camera_style.h>

#include "interaction/interaction_stage.h"
#include "support/law_meshes.h"
#include "support/meshes.h"
#include "support/source_tree.h"
#include "support/temporary_folder.h"

namespace holdfast {
namespace {

using test::EventLog;
using test::Hand;
using test::Held;
using test::InteractionStage;
using testing::Each;
using testing::ElementsAre;
using testing::Gt;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::IsSupersetOf;
using testing::Le;
using testing::Lt;
using testing::SizeIs;

constexpr unsigned long kRegionBegins = vtkCommand::StartInteractionEvent;
constexpr unsigned long kRegionGrows = vtkCommand::InteractionEvent;
constexpr unsigned long kRegionEnds = vtkCommand::EndInteractionEvent;
constexpr unsigned long kRegionCancelled = CancelInteractionEvent;

/// A window with a region widget, and a selection that follows it as an observer is told to.
class RegionWindow {
 public:
  explicit RegionWindow(Mesh mesh, int width = 400, int height = 300) : stage(std::move(mesh), width, height)
  {
    widget->SetInteractor(&stage.interactor());
    widget->SetCurrentRenderer(&stage.renderer());
    widget->SetSurface(stage.surface());
    widget->SetRegions(std::make_shared<VertexRegions>(stage.model().mesh, stage.model().solverMesh));
    for (const unsigned long event : {kRegionBegins, kRegionGrows, kRegionEnds, kRegionCancelled})
      widget->AddObserver(event, this, &RegionWindow::follow);
    widget->On();
  }

  void follow(vtkObject* /*widget*/, unsigned long event, void* callData)
  {
    const auto& data = *static_cast<RegionCallData*>(callData);
    if (event == kRegionBegins) before = selected;
    if (event == kRegionGrows || event == kRegionEnds) selected = joined(before, data.reached, data.mode);
    if (event == kRegionCancelled) selected = before;
    events.push_back(event);
    reached.push_back(data.reached);
    modes.push_back(data.mode);
  }

  /// Leaves the interactor of the stage for another one.
  void listenTo(vtkRenderWindowInteractor& interactor)
  {
    widget->Off();
    interactor.SetRenderWindow(&stage.window());
    interactor.SetInteractorStyle(nullptr);
    interactor.Initialize();
    widget->SetInteractor(&interactor);
    widget->SetCurrentRenderer(&stage.renderer());
    widget->On();
  }

  [[nodiscard]] Hand& hand() { return stage.hand(); }
  [[nodiscard]] DisplayPoint pixelOf(double x, double y) const { return stage.pixelOf({x, y, 0}); }
  [[nodiscard]] const std::vector<DisplayPoint>& outline() const
  {
    return widget->GetRegionRepresentation()->GetOutline();
  }
  /// Pixels between the places of the grid (0, 0) and (1, 0).
  [[nodiscard]] double pixelsOfUnit() const { return (pixelOf(1, 0) - pixelOf(0, 0)).norm(); }

  InteractionStage stage;
  vtkNew<RegionWidget> widget;
  std::vector<Index> before;
  std::vector<Index> selected;
  std::vector<unsigned long> events;
  std::vector<std::vector<Index>> reached;
  std::vector<SelectionMode> modes;
};

/// Vertex (i, j) of the grid is 11 j + i.
struct RegionsOfGrid : testing::Test, RegionWindow {
  RegionsOfGrid() : RegionWindow(test::grid(10, 8)) {}
};

/// Vertices of the grid no farther from (x, y) than `radius`.
std::vector<Index> gridBall(double x, double y, double radius)
{
  std::vector<Index> vertices;
  for (Index v = 0; v < 99; ++v)
    if (std::hypot(static_cast<double>(v % 11) - x, static_cast<double>(v / 11) - y) <= radius) vertices.push_back(v);
  return vertices;
}

TEST_F(RegionsOfGrid, ADabReachesTheVerticesUnderTheBrush)
{
  widget->SetBrushRadius(1.2 * pixelsOfUnit());
  hand().click(pixelOf(5, 4));
  EXPECT_THAT(events, ElementsAre(kRegionBegins, kRegionGrows, kRegionEnds));
  EXPECT_THAT(reached[0], IsEmpty());
  EXPECT_EQ(reached[1], gridBall(5, 4, 1.2));
  EXPECT_EQ(reached[2], gridBall(5, 4, 1.2));
}

TEST_F(RegionsOfGrid, AStrokeOfOneJumpReachesAllOnItsWay)
{
  widget->SetBrushRadius(0.6 * pixelsOfUnit());
  hand().press(pixelOf(1, 4));
  hand().moveTo(pixelOf(9, 4));
  hand().release(pixelOf(9, 4));
  EXPECT_THAT(events, ElementsAre(kRegionBegins, kRegionGrows, kRegionGrows, kRegionEnds));
  EXPECT_THAT(selected, ElementsAre(45, 46, 47, 48, 49, 50, 51, 52, 53));
}

TEST_F(RegionsOfGrid, AStrokeThatLeavesTheSurfaceGoesOnWhereItComesBack)
{
  widget->SetBrushRadius(0.6 * pixelsOfUnit());
  hand().drag({pixelOf(1, 7), pixelOf(1, 9.5), pixelOf(9, 9.5), pixelOf(9, 7)});
  EXPECT_THAT(selected, ElementsAre(78, 86, 89, 97));
}

TEST_F(RegionsOfGrid, PixelRatioScalesTheBrush)
{
  widget->SetBrushRadius(0.6 * pixelsOfUnit());
  widget->SetPixelRatio(2);
  hand().click(pixelOf(5, 4));
  EXPECT_EQ(selected, gridBall(5, 4, 1.2));
  EXPECT_NEAR((outline().front() - pixelOf(5, 4)).norm(), 1.2 * pixelsOfUnit(), 1e-9);
}

TEST_F(RegionsOfGrid, ShiftAddsAndCtrlTakesAway)
{
  widget->SetBrushRadius(0.6 * pixelsOfUnit());
  hand().click(pixelOf(2, 2));
  hand().click(pixelOf(5, 4), {.shift = true});
  EXPECT_THAT(selected, ElementsAre(24, 49));
  hand().click(pixelOf(2, 2), {.ctrl = true});
  EXPECT_THAT(selected, ElementsAre(49));
  hand().click(pixelOf(8, 6));
  EXPECT_THAT(selected, ElementsAre(74));
}

TEST_F(RegionsOfGrid, EscapeCancelsAStrokeAndTheRestOfItsDrag)
{
  selected = {1, 2, 3};
  hand().press(pixelOf(2, 2));
  hand().moveTo(pixelOf(5, 4));
  EXPECT_NE(selected, (std::vector<Index>{1, 2, 3}));
  hand().key("Escape");
  EXPECT_EQ(selected, (std::vector<Index>{1, 2, 3}));
  hand().moveTo(pixelOf(8, 4));
  hand().release(pixelOf(8, 4));
  EXPECT_THAT(events, ElementsAre(kRegionBegins, kRegionGrows, kRegionGrows, kRegionCancelled));
}

TEST_F(RegionsOfGrid, WhateverTakesTheGroundAwayCancels)
{
  const auto expectCancelled = [this](const char* what, auto&& action) {
    events.clear();
    hand().press(pixelOf(2, 2));
    action();
    EXPECT_THAT(events, ElementsAre(kRegionBegins, kRegionGrows, kRegionCancelled)) << what;
    hand().release(pixelOf(2, 2));
    EXPECT_THAT(events, SizeIs(3)) << what;
  };
  const auto regions = widget->GetRegions();
  expectCancelled("disabled", [this] { widget->Off(); });
  widget->SetCurrentRenderer(&stage.renderer());
  widget->On();
  expectCancelled("shape", [this] { widget->SetShape(RegionShape::Side); });
  widget->SetShape(RegionShape::Brush);
  expectCancelled("regions", [this] { widget->SetRegions(nullptr); });
  widget->SetRegions(regions);
  expectCancelled("surface", [this] { widget->SetSurface(nullptr); });
}

TEST_F(RegionsOfGrid, ObserversMayDisableTheWidgetAtAnyEvent)
{
  for (const RegionShape shape : {RegionShape::Brush, RegionShape::Rectangle, RegionShape::Side}) {
    for (const unsigned long event : {kRegionBegins, kRegionGrows, kRegionEnds}) {
      widget->SetShape(shape);
      const unsigned long tag = widget->AddObserver(event, widget.Get(), &RegionWidget::Off);
      hand().drag({pixelOf(2, 2), pixelOf(2.02, 2.02), pixelOf(2.03, 2)});
      hand().drag({pixelOf(2, 2), pixelOf(5, 5), pixelOf(6, 5)});
      widget->RemoveObserver(tag);
      widget->SetCurrentRenderer(&stage.renderer());
      widget->On();
      EXPECT_FALSE(widget->Cancel());
    }
  }
}

TEST_F(RegionsOfGrid, AStrokeGoesOnWhereTheSurfaceMovesMeanwhile)
{
  widget->SetBrushRadius(0.6 * pixelsOfUnit());
  auto moved = std::make_shared<Positions>(stage.surface()->positions());
  moved->col(0).array() += 1;
  hand().press(pixelOf(2, 2));
  widget->SetSurface(std::make_shared<const VisibleSurface>(stage.surface()->movedTo(moved)));
  hand().moveTo(pixelOf(4, 2));
  hand().release(pixelOf(4, 2));
  EXPECT_THAT(events, ElementsAre(kRegionBegins, kRegionGrows, kRegionGrows, kRegionEnds));
  EXPECT_THAT(selected,
              testing::AllOf(testing::Contains(24), testing::Contains(25), testing::Not(testing::Contains(26))));
}

TEST_F(RegionsOfGrid, APressBesideTheSurfaceIsLeftToTheCamera)
{
  vtkNew<SurfaceCameraStyle> style;
  stage.interactor().SetInteractorStyle(style);
  const auto cameraAfter = [this](const std::vector<DisplayPoint>& way) {
    hand().drag(way);
    const double* eye = stage.renderer().GetActiveCamera()->GetPosition();
    return Vector3(eye);
  };
  const Vector3 rest(stage.renderer().GetActiveCamera()->GetPosition());
  EXPECT_EQ(cameraAfter({pixelOf(2, 2), pixelOf(4, 5)}), rest);
  EXPECT_THAT(events, Not(IsEmpty()));
  events.clear();
  EXPECT_NE(cameraAfter({{3, 3}, {60, 80}}), rest);
  EXPECT_THAT(events, IsEmpty());
}

TEST_F(RegionsOfGrid, TheBrushFollowsTheCursorAndVanishesWithIt)
{
  EXPECT_THAT(outline(), IsEmpty());
  hand().moveTo(pixelOf(2, 2));
  ASSERT_THAT(outline(), Not(IsEmpty()));
  for (const DisplayPoint& corner : outline()) EXPECT_NEAR((corner - pixelOf(2, 2)).norm(), 24, 1e-9);
  hand().moveTo(pixelOf(5, 2));
  EXPECT_NEAR((outline().front() - pixelOf(5, 2)).norm(), 24, 1e-9);
  EXPECT_EQ(stage.window().GetCurrentCursor(), VTK_CURSOR_CROSSHAIR);
  hand().leave();
  EXPECT_THAT(outline(), IsEmpty());
  EXPECT_EQ(stage.window().GetCurrentCursor(), VTK_CURSOR_DEFAULT);
  hand().moveTo(pixelOf(5, 2));
  widget->Off();
  EXPECT_THAT(outline(), IsEmpty());
  EXPECT_EQ(stage.window().GetCurrentCursor(), VTK_CURSOR_DEFAULT);
}

TEST_F(RegionsOfGrid, HoveringWaitsWhileTheCameraMoves)
{
  vtkNew<SurfaceCameraStyle> style;
  stage.interactor().SetInteractorStyle(style);
  hand().press({3, 3});
  // The style begins with this one, which it sees after the widget.
  hand().moveTo({10, 3});
  hand().moveTo({60, 80});
  EXPECT_NEAR((outline().front() - DisplayPoint(10, 3)).norm(), 24, 1e-9);
  hand().release({60, 80});
}

TEST_F(RegionsOfGrid, BracketsSizeTheBrushWithinItsLimits)
{
  EventLog changes(*widget, {vtkCommand::WidgetValueChangedEvent});
  hand().moveTo(pixelOf(5, 2));
  hand().key("bracketright");
  EXPECT_DOUBLE_EQ(widget->GetBrushRadius(), 24 * 1.2);
  EXPECT_NEAR((outline().front() - pixelOf(5, 2)).norm(), 24 * 1.2, 1e-9);
  hand().key("bracketleft");
  hand().key("bracketleft");
  EXPECT_DOUBLE_EQ(widget->GetBrushRadius(), 20);
  EXPECT_THAT(changes.events(), SizeIs(3));
  for (int k = 0; k < 20; ++k) hand().key("bracketleft");
  EXPECT_EQ(widget->GetBrushRadius(), 4);
  widget->SetBrushRadius(1e9);
  EXPECT_EQ(widget->GetBrushRadius(), 300);
  EXPECT_EQ(widget->GetSideAngle(), 20);
}

TEST_F(RegionsOfGrid, ARectangleReachesWhatLiesInIt)
{
  widget->SetShape(RegionShape::Rectangle);
  hand().press(pixelOf(1.5, 1.5));
  EXPECT_THAT(events, ElementsAre(kRegionBegins));
  hand().moveTo(pixelOf(3, 2));
  hand().moveTo(pixelOf(4.5, 3.5));
  EXPECT_THAT(outline(), ElementsAre(pixelOf(1.5, 1.5), DisplayPoint(pixelOf(4.5, 0).x(), pixelOf(0, 1.5).y()),
                                     pixelOf(4.5, 3.5), DisplayPoint(pixelOf(1.5, 0).x(), pixelOf(0, 3.5).y())));
  EXPECT_THAT(events, ElementsAre(kRegionBegins));
  hand().release(pixelOf(4.5, 3.5));
  EXPECT_THAT(events, ElementsAre(kRegionBegins, kRegionEnds));
  EXPECT_THAT(selected, ElementsAre(24, 25, 26, 35, 36, 37));
  EXPECT_THAT(outline(), IsEmpty());
}

TEST_F(RegionsOfGrid, ALassoReachesWhatItsLineEncloses)
{
  widget->SetShape(RegionShape::Lasso);
  hand().drag({pixelOf(0.5, 0.5), pixelOf(4.5, 0.5), pixelOf(4.5, 4.5), pixelOf(0.5, 4.5)});
  EXPECT_THAT(selected, SizeIs(16));
  hand().drag({pixelOf(0.5, 0.5), pixelOf(4.5, 0.5), pixelOf(4.5, 4.5)});
  EXPECT_THAT(selected, SizeIs(testing::AllOf(Gt(5u), Lt(11u))));
}

TEST_F(RegionsOfGrid, ModifiersOfAnOutlineCountWhereItEnds)
{
  widget->SetShape(RegionShape::Rectangle);
  selected = {0, 24, 98};
  hand().press(pixelOf(1.5, 1.5));
  hand().moveTo(pixelOf(2.5, 2.5));
  hand().release(pixelOf(2.5, 2.5), {.ctrl = true});
  EXPECT_THAT(selected, ElementsAre(0, 98));
  hand().press(pixelOf(1.5, 1.5));
  hand().moveTo(pixelOf(2.5, 2.5));
  hand().release(pixelOf(2.5, 2.5), {.shift = true});
  EXPECT_THAT(selected, ElementsAre(0, 24, 98));
}

TEST_F(RegionsOfGrid, AnOutlineOfHardlyAPixelSelectsNothing)
{
  selected = {1, 2, 3};
  for (const RegionShape shape : {RegionShape::Rectangle, RegionShape::Lasso}) {
    widget->SetShape(shape);
    events.clear();
    hand().drag({{100, 100}, {102, 101}});
    EXPECT_THAT(events, ElementsAre(kRegionBegins, kRegionCancelled));
    EXPECT_THAT(selected, ElementsAre(1, 2, 3));
  }
  widget->SetPixelRatio(2);
  hand().drag({{100, 100}, {105, 100}});
  EXPECT_THAT(selected, ElementsAre(1, 2, 3));
}

TEST_F(RegionsOfGrid, EscapeTakesAnOutlineBack)
{
  widget->SetShape(RegionShape::Lasso);
  hand().press(pixelOf(1.5, 1.5));
  hand().moveTo(pixelOf(4.5, 3.5));
  hand().key("Escape");
  EXPECT_THAT(outline(), IsEmpty());
  hand().release(pixelOf(4.5, 3.5));
  EXPECT_THAT(events, ElementsAre(kRegionBegins, kRegionCancelled));
}

TEST_F(RegionsOfGrid, KeysThatAreNotUsedGoOn)
{
  EventLog keys(stage.interactor(), {vtkCommand::KeyPressEvent});
  hand().key("bracketleft");
  EXPECT_THAT(keys.events(), IsEmpty());
  hand().key("Escape");
  EXPECT_THAT(keys.events(), SizeIs(1));
  widget->SetShape(RegionShape::Rectangle);
  hand().key("bracketleft");
  EXPECT_THAT(keys.events(), SizeIs(2));
}

TEST_F(RegionsOfGrid, OtherRenderersKeepTheirEvents)
{
  vtkNew<vtkRenderer> other;
  stage.renderer().SetViewport(0, 0, 0.5, 1);
  other->SetViewport(0.5, 0, 1, 1);
  stage.window().AddRenderer(other);
  for (const RegionShape shape : {RegionShape::Brush, RegionShape::Rectangle, RegionShape::Lasso}) {
    widget->SetShape(shape);
    hand().drag({{250, 150}, {300, 180}});
    EXPECT_THAT(events, IsEmpty());
    EXPECT_THAT(outline(), IsEmpty());
  }
  hand().drag({{80, 150}, {120, 180}, {80, 180}});
  EXPECT_THAT(events, Not(IsEmpty()));
}

TEST_F(RegionsOfGrid, PriorityTellsWhoIsAskedFirst)
{
  vtkNew<vtkHandleWidget> handle;
  vtkNew<vtkPointHandleRepresentation3D> ball;
  handle->SetRepresentation(ball);
  handle->SetInteractor(&stage.interactor());
  handle->SetCurrentRenderer(&stage.renderer());
  double place[3] = {5, 4, 0};
  ball->PlaceWidget(stage.renderer().ComputeVisiblePropBounds());
  ball->SetWorldPosition(place);
  handle->On();
  const auto isHandleMoved = [&] {
    hand().drag({pixelOf(5, 4), pixelOf(6, 4)});
    return Vector3(ball->GetWorldPosition()).x() > 5.5;
  };
  widget->SetPriority(0.6F);
  EXPECT_FALSE(isHandleMoved());
  EXPECT_THAT(events, Not(IsEmpty()));
  events.clear();
  widget->SetPriority(0.4F);
  EXPECT_TRUE(isHandleMoved());
  EXPECT_THAT(events, IsEmpty());
}

TEST_F(RegionsOfGrid, BindingsCanBeChanged)
{
  widget->Off();
  vtkWidgetEventTranslator& translator = *widget->GetEventTranslator();
  translator.ClearEvents();
  translator.SetTranslation(vtkCommand::RightButtonPressEvent, vtkWidgetEvent::Select);
  translator.SetTranslation(vtkCommand::RightButtonReleaseEvent, vtkWidgetEvent::EndSelect);
  widget->SetCurrentRenderer(&stage.renderer());
  widget->On();
  hand().click(pixelOf(5, 4));
  EXPECT_THAT(events, IsEmpty());
  hand().rightPress(pixelOf(5, 4));
  hand().rightRelease(pixelOf(5, 4));
  EXPECT_THAT(events, ElementsAre(kRegionBegins, kRegionGrows, kRegionEnds));
}

TEST_F(RegionsOfGrid, ARecordedGestureReachesTheSameAgain)
{
  const test::TemporaryFolder folder;
  const std::string path = (folder.path() / "stroke.log").string();
  vtkNew<vtkInteractorEventRecorder> recorder;
  recorder->SetInteractor(&stage.interactor());
  recorder->SetFileName(path.c_str());
  recorder->On();
  recorder->Record();
  hand().drag({pixelOf(1, 1), pixelOf(4, 4), pixelOf(8, 4)});
  recorder->Stop();
  recorder->Off();
  const auto recorded = std::exchange(reached, {});
  ASSERT_THAT(recorded, SizeIs(Gt(3u)));

  vtkNew<vtkInteractorEventRecorder> player;
  player->SetInteractor(&stage.interactor());
  player->SetFileName(path.c_str());
  player->On();
  player->Play();
  EXPECT_EQ(reached, recorded);
}

TEST_F(RegionsOfGrid, PrintsItsState)
{
  std::ostringstream text;
  widget->Print(text);
  widget->GetRegionRepresentation()->Print(text);
  EXPECT_THAT(text.str(),
              testing::AllOf(HasSubstr("BrushRadius: 24"), HasSubstr("SideAngle: 20"), HasSubstr("Outline: 0")));
}

TEST_F(RegionsOfGrid, WithoutASurfaceNothingHappens)
{
  widget->SetSurface(nullptr);
  for (const RegionShape shape : {RegionShape::Brush, RegionShape::Rectangle, RegionShape::Lasso, RegionShape::Side}) {
    widget->SetShape(shape);
    hand().drag({pixelOf(1, 1), pixelOf(4, 4)});
    hand().doubleClick(pixelOf(4, 4));
  }
  widget->SetSurface(stage.surface());
  widget->SetRegions(nullptr);
  for (const RegionShape shape : {RegionShape::Brush, RegionShape::Side}) {
    widget->SetShape(shape);
    hand().drag({pixelOf(1, 1), pixelOf(4, 4)});
    hand().doubleClick(pixelOf(4, 4));
  }
  EXPECT_THAT(events, IsEmpty());
}

TEST_F(RegionsOfGrid, OutlinesAreLightBelowDark)
{
  hand().moveTo(pixelOf(5, 4));
  const DisplayPoint onCircle = pixelOf(5, 4) + DisplayPoint(24, 0);
  EXPECT_THAT(stage.colorAt(onCircle), Each(Lt(110)));
  EXPECT_THAT(stage.colorAt(onCircle + DisplayPoint(2, 0)), testing::Not(Each(Lt(110))));
  const int light = stage.countPixels({240, 240, 240}, 20);
  EXPECT_GT(light, 100);
  hand().leave();
  EXPECT_LT(stage.countPixels({240, 240, 240}, 20), light / 10);
}

TEST_F(RegionsOfGrid, ALassoIsFilledWhereItEncloses)
{
  widget->SetShape(RegionShape::Lasso);
  const std::vector<int> plain = stage.colorAt(pixelOf(3.3, 3.4));
  hand().press(pixelOf(1, 1));
  // A square with a smaller one in it, drawn in one line.
  for (const auto& [x, y] : {std::pair(8, 1), {8, 7}, {1, 7}, {1, 1}, {4, 4}, {6, 4}, {6, 6}, {4, 6}, {4, 4}})
    hand().moveTo(pixelOf(x, y));
  EXPECT_EQ(stage.colorAt(pixelOf(5, 5)), plain);
  EXPECT_EQ(stage.colorAt(pixelOf(0.5, 0.5)), plain);
  const std::vector<int> inside = stage.colorAt(pixelOf(3.3, 3.4));
  EXPECT_GT(inside[2], plain[2]);
  EXPECT_LT(inside[0], plain[0]);
}

/// A box seen from its corner: three sides of 25 vertices each.
struct RegionsOfBox : testing::Test, RegionWindow {
  RegionsOfBox() : RegionWindow(test::merged(test::box({1, 1, 1}, 4), test::moved(test::box({1, 1, 1}, 4), {3, 0, 0})))
  {
    stage.renderer().GetActiveCamera()->Azimuth(30);
    stage.renderer().GetActiveCamera()->Elevation(30);
    stage.renderer().ResetCamera();
    widget->SetShape(RegionShape::Side);
  }

  DisplayPoint onTop = stage.pixelOf({0.55, 1, 0.45});
};

TEST_F(RegionsOfBox, AClickSelectsTheSide)
{
  const Positions& places = stage.model().mesh.positions;
  // Wherever the box stands: its topmost vertices.
  const double top = places.col(1).maxCoeff();
  const Vector3 least = places.colwise().minCoeff();
  onTop = stage.pixelOf({least.x() + 0.55, top, least.z() + 0.45});
  hand().click(onTop);
  EXPECT_THAT(events, ElementsAre(kRegionBegins, kRegionEnds));
  EXPECT_THAT(selected, SizeIs(25));
  for (const Index vertex : selected) EXPECT_EQ(places(vertex, 1), top);
  hand().click(onTop, {.ctrl = true});
  EXPECT_THAT(selected, IsEmpty());
}

TEST_F(RegionsOfBox, ADoubleClickSelectsTheConnectedPart)
{
  hand().doubleClick(onTop);
  EXPECT_THAT(selected, SizeIs(stage.model().mesh.vertexCount() / 2));
  EXPECT_THAT(events, ElementsAre(kRegionBegins, kRegionEnds, kRegionBegins, kRegionEnds));
  events.clear();
  stage.interactor().SetEventInformation(static_cast<int>(onTop.x()), static_cast<int>(onTop.y()));
  stage.interactor().InvokeEvent(vtkCommand::LeftButtonDoubleClickEvent);
  EXPECT_THAT(events, ElementsAre(kRegionBegins, kRegionEnds));
}

TEST_F(RegionsOfBox, ADragFromASideTurnsThePictureAndSelectsNothing)
{
  vtkNew<SurfaceCameraStyle> style;
  stage.interactor().SetInteractorStyle(style);
  const Vector3 eye(stage.renderer().GetActiveCamera()->GetPosition());
  hand().drag({onTop, onTop + DisplayPoint(6, 0), onTop + DisplayPoint(30, 5)});
  EXPECT_THAT(events, IsEmpty());
  EXPECT_NE(Vector3(stage.renderer().GetActiveCamera()->GetPosition()), eye);
  stage.interactor().SetInteractorStyle(nullptr);
  hand().drag({onTop, onTop + DisplayPoint(6, 0), onTop});
  EXPECT_THAT(events, IsEmpty()) << "the hand came back";
  // Four pixels of a display of high resolution are eight.
  widget->SetPixelRatio(2);
  hand().drag({onTop, onTop + DisplayPoint(6, 0)});
  EXPECT_THAT(events, ElementsAre(kRegionBegins, kRegionEnds));
}

TEST_F(RegionsOfBox, BracketsChangeTheAngleOfASide)
{
  EventLog changes(*widget, {vtkCommand::WidgetValueChangedEvent});
  for (int k = 0; k < 14; ++k) hand().key("bracketright");
  EXPECT_EQ(widget->GetSideAngle(), 90);
  EXPECT_THAT(changes.events(), SizeIs(14));
  hand().key("bracketright");
  hand().click(onTop);
  EXPECT_THAT(selected, SizeIs(stage.model().mesh.vertexCount() / 2));
  for (int k = 0; k < 100; ++k) hand().key("bracketright");
  EXPECT_EQ(widget->GetSideAngle(), 175);
  for (int k = 0; k < 100; ++k) hand().key("bracketleft");
  EXPECT_EQ(widget->GetSideAngle(), 0);
  EXPECT_EQ(widget->GetBrushRadius(), 24);
}

/// An interactor of a window that has an event loop. Timers go off when the test says so.
class TimedInteractor : public vtkRenderWindowInteractor {
 public:
  static TimedInteractor* New();
  vtkTypeMacro(TimedInteractor, vtkRenderWindowInteractor)

  std::vector<int> timers;

 protected:
  int InternalCreateTimer(int timerId, int /*type*/, unsigned long /*duration*/) override
  {
    timers.push_back(timerId);
    return timerId;
  }
  int InternalDestroyTimer(int timerId) override { return static_cast<int>(std::erase(timers, timerId)); }
};

vtkStandardNewMacro(TimedInteractor);

/// A rectangle for more vertices than are looked at in one turn.
struct RegionsOfLargeGrid : testing::Test, RegionWindow {
  RegionsOfLargeGrid() : RegionWindow(test::grid(150, 200)) { widget->SetShape(RegionShape::Rectangle); }
};

struct RegionsInTurns : RegionsOfLargeGrid {
  RegionsInTurns() { listenTo(*timed); }

  void fire(int timer) { timed->InvokeEvent(vtkCommand::TimerEvent, &timer); }
  void draw() { Hand(*timed).drag({pixelOf(20.5, 20.5), pixelOf(120.5, 150.5)}); }

  vtkNew<TimedInteractor> timed;
};

TEST_F(RegionsInTurns, LooksAtLargeMeshesInTurnsOfTheEventLoop)
{
  draw();
  EXPECT_THAT(events, ElementsAre(kRegionBegins));
  ASSERT_THAT(timed->timers, SizeIs(1));
  fire(timed->timers.back() + 1);
  EXPECT_THAT(timed->timers, SizeIs(1));
  fire(timed->timers.back());
  EXPECT_THAT(events, ElementsAre(kRegionBegins));
  ASSERT_THAT(timed->timers, SizeIs(2));
  fire(timed->timers.front());
  EXPECT_THAT(timed->timers, SizeIs(2));
  fire(timed->timers.back());
  EXPECT_THAT(events, ElementsAre(kRegionBegins, kRegionEnds));
  EXPECT_THAT(selected, SizeIs(100 * 130));
}

TEST_F(RegionsInTurns, EscapeAndANewGestureStopTheSearch)
{
  draw();
  const int first = timed->timers.back();
  Hand(*timed).key("Escape");
  EXPECT_THAT(events, ElementsAre(kRegionBegins, kRegionCancelled));
  EXPECT_THAT(timed->timers, IsEmpty());
  fire(first);
  EXPECT_THAT(events, ElementsAre(kRegionBegins, kRegionCancelled));
  draw();
  Hand(*timed).press(pixelOf(20.5, 20.5));
  EXPECT_THAT(events, ElementsAre(kRegionBegins, kRegionCancelled, kRegionBegins, kRegionCancelled, kRegionBegins));
}

TEST_F(RegionsOfLargeGrid, AreFoundAtOnceWithoutTimers)
{
  vtkNew<vtkGenericRenderWindowInteractor> withoutTimers;
  listenTo(*withoutTimers);
  Hand(*withoutTimers).drag({pixelOf(20.5, 20.5), pixelOf(120.5, 150.5)});
  EXPECT_THAT(events, ElementsAre(kRegionBegins, kRegionEnds));
  EXPECT_THAT(selected, SizeIs(100 * 130));
}

/// The head from the front, without timers.
struct RegionsOfHead : testing::Test, RegionWindow {
  RegionsOfHead() : RegionWindow(readMesh(test::dataFolder() + "/head.ply").mesh, 640, 480)
  {
    vtkCamera& camera = *stage.renderer().GetActiveCamera();
    camera.SetPosition(0, -1, 0);
    camera.SetFocalPoint(0, 0, 0);
    camera.SetViewUp(0, 0, 1);
    stage.renderer().ResetCamera();
    listenTo(*withoutTimers);
  }

  [[nodiscard]] Vector3 placeOf(Index vertex) const { return stage.model().mesh.positions.row(vertex).transpose(); }

  vtkNew<vtkGenericRenderWindowInteractor> withoutTimers;
  Hand hand{*withoutTimers};
};

TEST_F(RegionsOfHead, ARectangleReachesWhatIsSeenInIt)
{
  widget->SetShape(RegionShape::Rectangle);
  const DisplayPoint low = stage.pixelOf({10, -76, 10});
  const DisplayPoint high = stage.pixelOf({45, -76, 42});
  hand.drag({low, high});
  EXPECT_THAT(selected, SizeIs(Gt(20u)));
  for (const Index vertex : selected) {
    const DisplayPoint pixel = stage.pixelOfVertex(vertex);
    EXPECT_TRUE(pixel.x() >= low.x() - 1 && pixel.x() <= high.x() + 1);
    EXPECT_TRUE(pixel.y() >= low.y() - 1 && pixel.y() <= high.y() + 1);
    EXPECT_LT(placeOf(vertex).y(), 0) << "the back of the head is hidden";
  }
  const auto visible = selected;
  hand.drag({low, high}, {.alt = true});
  EXPECT_THAT(selected, SizeIs(Gt(visible.size())));
  EXPECT_THAT(selected, IsSupersetOf(visible));

  widget->SetShape(RegionShape::Lasso);
  hand.drag({low, {high.x(), low.y()}, high, {low.x(), high.y()}, low});
  EXPECT_EQ(selected, visible);
}

TEST_F(RegionsOfHead, TheBrushPaintsAddsAndTakesAway)
{
  const DisplayPoint eye = stage.pixelOf({27, -84, 25});
  hand.drag({eye, eye + DisplayPoint(20, 0), eye + DisplayPoint(40, 0)});
  const auto painted = selected;
  ASSERT_THAT(painted, SizeIs(Gt(5u)));
  const DisplayPoint chin = stage.pixelOf({0, -84, -50});
  hand.drag({chin, chin + DisplayPoint(10, 0)}, {.shift = true});
  EXPECT_THAT(selected, SizeIs(Gt(painted.size())));
  hand.drag({chin, chin + DisplayPoint(10, 0)}, {.ctrl = true});
  EXPECT_EQ(selected, painted);
}

TEST_F(RegionsOfHead, SidesFollowTheAngleAndDoubleClicksTakeAll)
{
  widget->SetShape(RegionShape::Side);
  const DisplayPoint eye = stage.pixelOf({27, -84, 25});
  hand.click(eye);
  const auto usual = selected;
  widget->SetSideAngle(5);
  hand.click(eye);
  EXPECT_THAT(selected, SizeIs(Lt(usual.size())));
  hand.doubleClick(eye);
  EXPECT_THAT(selected, SizeIs(stage.model().mesh.vertexCount()));
}

}  // namespace
}  // namespace holdfast
