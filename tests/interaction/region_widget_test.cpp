#include <sstream>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkGenericRenderWindowInteractor.h>
#include <vtkHandleWidget.h>
#include <vtkInteractorEventRecorder.h>
#include <vtkPointHandleRepresentation3D.h>
#include <vtkRenderWindow.h>
#include <vtkWidgetEvent.h>
#include <vtkWidgetEventTranslator.h>

#include <holdfast/io/mesh_file.h>

#include "holdfast/widgets/interaction/vtkHoldfastRegionWidget.h"
#include "interaction/region_window.h"
#include "support/source_tree.h"
#include "support/temporary_folder.h"

namespace holdfast {
namespace {

using test::EventLog;
using test::kBegins;
using test::kCancels;
using test::kEnds;
using test::kMoves;
using test::Mouse;
using test::RegionsOfGrid;
using test::RegionWindow;
using testing::ElementsAre;
using testing::Gt;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::IsSupersetOf;
using testing::Lt;
using testing::SizeIs;

TEST_F(RegionsOfGrid, WhateverTakesTheGroundAwayCancels)
{
  const auto expectCancelled = [this](const char* what, auto&& action) {
    events.clear();
    mouse().press(pixelOf(2, 2));
    action();
    EXPECT_THAT(events, ElementsAre(kBegins, kMoves, kCancels)) << what;
    mouse().release(pixelOf(2, 2));
    EXPECT_THAT(events, SizeIs(3)) << what;
  };
  const auto regions = widget->GetRegions();
  expectCancelled("disabled", [this] { widget->Off(); });
  fixture.enable(*widget);
  expectCancelled("shape", [this] { widget->SetShape(RegionShape::Side); });
  widget->SetShape(RegionShape::Brush);
  expectCancelled("regions", [this] { widget->SetRegions(nullptr); });
  widget->SetRegions(regions);
  expectCancelled("surface", [this] { widget->SetSurface(nullptr); });
}

TEST_F(RegionsOfGrid, ObserversMayDisableTheWidgetAtAnyEvent)
{
  for (const RegionShape shape : {RegionShape::Brush, RegionShape::Rectangle, RegionShape::Side}) {
    for (const unsigned long event : {kBegins, kMoves, kEnds}) {
      widget->SetShape(shape);
      const unsigned long tag = widget->AddObserver(event, widget.Get(), &vtkHoldfastRegionWidget::Off);
      mouse().drag({pixelOf(2, 2), pixelOf(2.02, 2.02), pixelOf(2.03, 2)});
      mouse().drag({pixelOf(2, 2), pixelOf(5, 5), pixelOf(6, 5)});
      widget->RemoveObserver(tag);
      fixture.enable(*widget);
      EXPECT_FALSE(widget->Cancel());
    }
  }
}

TEST_F(RegionsOfGrid, KeysThatAreNotUsedGoOn)
{
  EventLog keys(fixture.interactor(), {vtkCommand::KeyPressEvent});
  mouse().key("bracketleft");
  EXPECT_THAT(keys.events(), IsEmpty());
  mouse().key("Escape");
  EXPECT_THAT(keys.events(), SizeIs(1));
  widget->SetShape(RegionShape::Rectangle);
  mouse().key("bracketleft");
  EXPECT_THAT(keys.events(), SizeIs(2));
}

TEST_F(RegionsOfGrid, OtherRenderersKeepTheirEvents)
{
  vtkNew<vtkRenderer> other;
  fixture.renderer().SetViewport(0, 0, 0.5, 1);
  other->SetViewport(0.5, 0, 1, 1);
  fixture.window().AddRenderer(other);
  for (const RegionShape shape : {RegionShape::Brush, RegionShape::Rectangle, RegionShape::Lasso}) {
    widget->SetShape(shape);
    mouse().drag({{250, 150}, {300, 180}});
    EXPECT_THAT(events, IsEmpty());
    EXPECT_THAT(outline(), IsEmpty());
  }
  mouse().drag({{80, 150}, {120, 180}, {80, 180}});
  EXPECT_THAT(events, Not(IsEmpty()));
}

TEST_F(RegionsOfGrid, PriorityTellsWhoIsAskedFirst)
{
  vtkNew<vtkHandleWidget> handle;
  vtkNew<vtkPointHandleRepresentation3D> ball;
  handle->SetRepresentation(ball);
  handle->SetInteractor(&fixture.interactor());
  handle->SetCurrentRenderer(&fixture.renderer());
  double place[3] = {5, 4, 0};
  ball->PlaceWidget(fixture.renderer().ComputeVisiblePropBounds());
  ball->SetWorldPosition(place);
  handle->On();
  const auto isHandleMoved = [&] {
    mouse().drag({pixelOf(5, 4), pixelOf(6, 4)});
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
  fixture.enable(*widget);
  mouse().click(pixelOf(5, 4));
  EXPECT_THAT(events, IsEmpty());
  mouse().rightPress(pixelOf(5, 4));
  mouse().rightRelease(pixelOf(5, 4));
  EXPECT_THAT(events, ElementsAre(kBegins, kMoves, kEnds));
}

TEST_F(RegionsOfGrid, ARecordedGestureReachesTheSameAgain)
{
  const test::TemporaryFolder folder;
  const std::string path = (folder.path() / "stroke.log").string();
  vtkNew<vtkInteractorEventRecorder> recorder;
  recorder->SetInteractor(&fixture.interactor());
  recorder->SetFileName(path.c_str());
  recorder->On();
  recorder->Record();
  mouse().drag({pixelOf(1, 1), pixelOf(4, 4), pixelOf(8, 4)});
  recorder->Stop();
  recorder->Off();
  const auto recorded = std::exchange(reached, {});
  ASSERT_THAT(recorded, SizeIs(Gt(3u)));

  vtkNew<vtkInteractorEventRecorder> player;
  player->SetInteractor(&fixture.interactor());
  player->SetFileName(path.c_str());
  player->On();
  player->Play();
  EXPECT_EQ(reached, recorded);
}

TEST_F(RegionsOfGrid, PrintsItsState)
{
  std::ostringstream text;
  widget->Print(text);
  EXPECT_THAT(text.str(), testing::AllOf(HasSubstr("BrushRadius: 24"), HasSubstr("SideAngle: 20")));
}

TEST_F(RegionsOfGrid, WithoutASurfaceNothingHappens)
{
  widget->SetSurface(nullptr);
  for (const RegionShape shape : {RegionShape::Brush, RegionShape::Rectangle, RegionShape::Lasso, RegionShape::Side}) {
    widget->SetShape(shape);
    mouse().drag({pixelOf(1, 1), pixelOf(4, 4)});
    mouse().doubleClick(pixelOf(4, 4));
  }
  widget->SetSurface(fixture.surface());
  widget->SetRegions(nullptr);
  for (const RegionShape shape : {RegionShape::Brush, RegionShape::Side}) {
    widget->SetShape(shape);
    mouse().drag({pixelOf(1, 1), pixelOf(4, 4)});
    mouse().doubleClick(pixelOf(4, 4));
  }
  EXPECT_THAT(events, IsEmpty());
}

/// The head from the front, without timers.
struct RegionsOfHead : testing::Test, RegionWindow {
  RegionsOfHead() : RegionWindow(readMesh(test::dataFolder() + "/head.ply").mesh, 640, 480)
  {
    fixture.lookFromFront();
    listenTo(*withoutTimers);
  }

  [[nodiscard]] Vector3 placeOf(Index vertex) const { return fixture.model().mesh.positions.row(vertex).transpose(); }

  vtkNew<vtkGenericRenderWindowInteractor> withoutTimers;
  Mouse mouse{*withoutTimers};
};

TEST_F(RegionsOfHead, ARectangleReachesWhatIsSeenInIt)
{
  widget->SetShape(RegionShape::Rectangle);
  const DisplayPoint low = fixture.pixelOf({10, -76, 10});
  const DisplayPoint high = fixture.pixelOf({45, -76, 42});
  mouse.drag({low, high});
  EXPECT_THAT(selected, SizeIs(Gt(20u)));
  for (const Index vertex : selected) {
    const DisplayPoint pixel = fixture.pixelOfVertex(vertex);
    EXPECT_TRUE(pixel.x() >= low.x() - 1 && pixel.x() <= high.x() + 1);
    EXPECT_TRUE(pixel.y() >= low.y() - 1 && pixel.y() <= high.y() + 1);
    EXPECT_LT(placeOf(vertex).y(), 0) << "the back of the head is hidden";
  }
  const auto visible = selected;
  mouse.drag({low, high}, {.alt = true});
  EXPECT_THAT(selected, SizeIs(Gt(visible.size())));
  EXPECT_THAT(selected, IsSupersetOf(visible));

  widget->SetShape(RegionShape::Lasso);
  mouse.drag({low, {high.x(), low.y()}, high, {low.x(), high.y()}, low});
  EXPECT_EQ(selected, visible);
}

TEST_F(RegionsOfHead, TheBrushPaintsAddsAndTakesAway)
{
  const DisplayPoint eye = fixture.pixelOf({27, -84, 25});
  mouse.drag({eye, eye + DisplayPoint(20, 0), eye + DisplayPoint(40, 0)});
  const auto painted = selected;
  ASSERT_THAT(painted, SizeIs(Gt(5u)));
  const DisplayPoint chin = fixture.pixelOf({0, -84, -50});
  mouse.drag({chin, chin + DisplayPoint(10, 0)}, {.shift = true});
  EXPECT_THAT(selected, SizeIs(Gt(painted.size())));
  mouse.drag({chin, chin + DisplayPoint(10, 0)}, {.ctrl = true});
  EXPECT_EQ(selected, painted);
}

TEST_F(RegionsOfHead, SidesFollowTheAngleAndDoubleClicksTakeAll)
{
  widget->SetShape(RegionShape::Side);
  const DisplayPoint eye = fixture.pixelOf({27, -84, 25});
  mouse.click(eye);
  const auto usual = selected;
  widget->SetSideAngle(5);
  mouse.click(eye);
  EXPECT_THAT(selected, SizeIs(Lt(usual.size())));
  mouse.doubleClick(eye);
  EXPECT_THAT(selected, SizeIs(fixture.model().mesh.vertexCount()));
}

}  // namespace
}  // namespace holdfast
