#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkGenericRenderWindowInteractor.h>
#include <vtkObjectFactory.h>

#include "interaction/region_window.h"
#include "support/meshes.h"

namespace holdfast {
namespace {

using test::kBegins;
using test::kCancels;
using test::kEnds;
using test::Mouse;
using test::RegionsOfGrid;
using test::RegionWindow;
using testing::Each;
using testing::ElementsAre;
using testing::Gt;
using testing::IsEmpty;
using testing::Lt;
using testing::SizeIs;

TEST_F(RegionsOfGrid, ARectangleReachesWhatLiesInIt)
{
  widget->SetShape(RegionShape::Rectangle);
  mouse().press(pixelOf(1.5, 1.5));
  EXPECT_THAT(events, ElementsAre(kBegins));
  mouse().moveTo(pixelOf(3, 2));
  mouse().moveTo(pixelOf(4.5, 3.5));
  EXPECT_THAT(outline(), ElementsAre(pixelOf(1.5, 1.5), DisplayPoint(pixelOf(4.5, 0).x(), pixelOf(0, 1.5).y()),
                                     pixelOf(4.5, 3.5), DisplayPoint(pixelOf(1.5, 0).x(), pixelOf(0, 3.5).y())));
  EXPECT_THAT(events, ElementsAre(kBegins));
  mouse().release(pixelOf(4.5, 3.5));
  EXPECT_THAT(events, ElementsAre(kBegins, kEnds));
  EXPECT_THAT(selected, ElementsAre(24, 25, 26, 35, 36, 37));
  EXPECT_THAT(outline(), IsEmpty());
}

TEST_F(RegionsOfGrid, ALassoReachesWhatItsLineEncloses)
{
  widget->SetShape(RegionShape::Lasso);
  mouse().drag({pixelOf(0.5, 0.5), pixelOf(4.5, 0.5), pixelOf(4.5, 4.5), pixelOf(0.5, 4.5)});
  EXPECT_THAT(selected, SizeIs(16));
  mouse().drag({pixelOf(0.5, 0.5), pixelOf(4.5, 0.5), pixelOf(4.5, 4.5)});
  EXPECT_THAT(selected, SizeIs(testing::AllOf(Gt(5u), Lt(11u))));
}

TEST_F(RegionsOfGrid, ModifiersOfAnOutlineCountWhereItEnds)
{
  widget->SetShape(RegionShape::Rectangle);
  selected = {0, 24, 98};
  mouse().press(pixelOf(1.5, 1.5));
  mouse().moveTo(pixelOf(2.5, 2.5));
  mouse().release(pixelOf(2.5, 2.5), {.ctrl = true});
  EXPECT_THAT(selected, ElementsAre(0, 98));
  mouse().press(pixelOf(1.5, 1.5));
  mouse().moveTo(pixelOf(2.5, 2.5));
  mouse().release(pixelOf(2.5, 2.5), {.shift = true});
  EXPECT_THAT(selected, ElementsAre(0, 24, 98));
}

TEST_F(RegionsOfGrid, AnOutlineOfHardlyAPixelSelectsNothing)
{
  selected = {1, 2, 3};
  for (const RegionShape shape : {RegionShape::Rectangle, RegionShape::Lasso}) {
    widget->SetShape(shape);
    events.clear();
    mouse().drag({{100, 100}, {102, 101}});
    EXPECT_THAT(events, ElementsAre(kBegins, kCancels));
    EXPECT_THAT(selected, ElementsAre(1, 2, 3));
  }
  widget->SetPixelRatio(2);
  mouse().drag({{100, 100}, {105, 100}});
  EXPECT_THAT(selected, ElementsAre(1, 2, 3));
}

TEST_F(RegionsOfGrid, EscapeTakesAnOutlineBack)
{
  widget->SetShape(RegionShape::Lasso);
  mouse().press(pixelOf(1.5, 1.5));
  mouse().moveTo(pixelOf(4.5, 3.5));
  mouse().key("Escape");
  EXPECT_THAT(outline(), IsEmpty());
  mouse().release(pixelOf(4.5, 3.5));
  EXPECT_THAT(events, ElementsAre(kBegins, kCancels));
}

TEST_F(RegionsOfGrid, OutlinesAreLightBelowDark)
{
  mouse().moveTo(pixelOf(5, 4));
  const DisplayPoint onCircle = pixelOf(5, 4) + DisplayPoint(24, 0);
  EXPECT_THAT(fixture.colorAt(onCircle), Each(Lt(110)));
  EXPECT_THAT(fixture.colorAt(onCircle + DisplayPoint(2, 0)), testing::Not(Each(Lt(110))));
  const int light = fixture.countPixels({240, 240, 240}, 20);
  EXPECT_GT(light, 100);
  mouse().leave();
  EXPECT_LT(fixture.countPixels({240, 240, 240}, 20), light / 10);
}

TEST_F(RegionsOfGrid, ALassoIsFilledWhereItEncloses)
{
  widget->SetShape(RegionShape::Lasso);
  const std::vector<int> plain = fixture.colorAt(pixelOf(3.3, 3.4));
  mouse().press(pixelOf(1, 1));
  // A square with a smaller one in it, drawn in one line.
  for (const auto& [x, y] : {std::pair(8, 1), {8, 7}, {1, 7}, {1, 1}, {4, 4}, {6, 4}, {6, 6}, {4, 6}, {4, 4}})
    mouse().moveTo(pixelOf(x, y));
  EXPECT_EQ(fixture.colorAt(pixelOf(5, 5)), plain);
  EXPECT_EQ(fixture.colorAt(pixelOf(0.5, 0.5)), plain);
  const std::vector<int> inside = fixture.colorAt(pixelOf(3.3, 3.4));
  EXPECT_GT(inside[2], plain[2]);
  EXPECT_LT(inside[0], plain[0]);
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
  void draw() { Mouse(*timed).drag({pixelOf(20.5, 20.5), pixelOf(120.5, 150.5)}); }

  vtkNew<TimedInteractor> timed;
};

TEST_F(RegionsInTurns, LooksAtLargeMeshesInTurnsOfTheEventLoop)
{
  draw();
  EXPECT_THAT(events, ElementsAre(kBegins));
  ASSERT_THAT(timed->timers, SizeIs(1));
  fire(timed->timers.back() + 1);
  EXPECT_THAT(timed->timers, SizeIs(1));
  fire(timed->timers.back());
  EXPECT_THAT(events, ElementsAre(kBegins));
  ASSERT_THAT(timed->timers, SizeIs(2));
  fire(timed->timers.front());
  EXPECT_THAT(timed->timers, SizeIs(2));
  fire(timed->timers.back());
  EXPECT_THAT(events, ElementsAre(kBegins, kEnds));
  EXPECT_THAT(selected, SizeIs(100 * 130));
}

TEST_F(RegionsInTurns, EscapeAndANewGestureStopTheSearch)
{
  draw();
  const int first = timed->timers.back();
  Mouse(*timed).key("Escape");
  EXPECT_THAT(events, ElementsAre(kBegins, kCancels));
  EXPECT_THAT(timed->timers, IsEmpty());
  fire(first);
  EXPECT_THAT(events, ElementsAre(kBegins, kCancels));
  draw();
  Mouse(*timed).press(pixelOf(20.5, 20.5));
  EXPECT_THAT(events, ElementsAre(kBegins, kCancels, kBegins, kCancels, kBegins));
}

TEST_F(RegionsOfLargeGrid, AreFoundAtOnceWithoutTimers)
{
  vtkNew<vtkGenericRenderWindowInteractor> withoutTimers;
  listenTo(*withoutTimers);
  Mouse(*withoutTimers).drag({pixelOf(20.5, 20.5), pixelOf(120.5, 150.5)});
  EXPECT_THAT(events, ElementsAre(kBegins, kEnds));
  EXPECT_THAT(selected, SizeIs(100 * 130));
}

}  // namespace
}  // namespace holdfast
