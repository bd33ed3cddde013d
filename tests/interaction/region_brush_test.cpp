#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkRenderWindow.h>

#include <holdfast/widgets/interaction/vtkHoldfastSurfaceCameraStyle.h>

#include "interaction/region_window.h"

namespace holdfast {
namespace {

using test::EventLog;
using test::kBegins;
using test::kCancels;
using test::kEnds;
using test::kMoves;
using test::RegionsOfGrid;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

/// Vertices of the grid no farther from (x, y) than `radius`.
std::vector<Index> gridBall(double x, double y, double radius)
{
  std::vector<Index> vertices;
  for (Index v = 0; v < 99; ++v)
    if (std::hypot(static_cast<double>(v % 11) - x, std::floor(static_cast<double>(v) / 11) - y) <= radius)
      vertices.push_back(v);
  return vertices;
}

TEST_F(RegionsOfGrid, ADabReachesTheVerticesUnderTheBrush)
{
  widget->SetBrushRadius(1.2 * pixelsOfUnit());
  mouse().click(pixelOf(5, 4));
  EXPECT_THAT(events, ElementsAre(kBegins, kMoves, kEnds));
  EXPECT_THAT(reached[0], IsEmpty());
  EXPECT_EQ(reached[1], gridBall(5, 4, 1.2));
  EXPECT_EQ(reached[2], gridBall(5, 4, 1.2));
}

TEST_F(RegionsOfGrid, ADabReachesNothingThatASectionCutsAway)
{
  widget->SetBrushRadius(1.2 * pixelsOfUnit());
  const SectionPlane section{{4.5, 0, 0}, {1, 0, 0}};
  widget->SetSurface(std::make_shared<const VisibleSurface>(fixture.surface()->withSection(section)));
  mouse().click(pixelOf(5, 4));
  EXPECT_THAT(selected, ElementsAre(38, 49, 50, 60));
}

TEST_F(RegionsOfGrid, AStrokeOfOneJumpReachesAllOnItsWay)
{
  widget->SetBrushRadius(0.6 * pixelsOfUnit());
  mouse().press(pixelOf(1, 4));
  mouse().moveTo(pixelOf(9, 4));
  mouse().release(pixelOf(9, 4));
  EXPECT_THAT(events, ElementsAre(kBegins, kMoves, kMoves, kEnds));
  EXPECT_THAT(selected, ElementsAre(45, 46, 47, 48, 49, 50, 51, 52, 53));
}

TEST_F(RegionsOfGrid, AStrokeThatLeavesTheSurfaceGoesOnWhereItComesBack)
{
  widget->SetBrushRadius(0.6 * pixelsOfUnit());
  mouse().drag({pixelOf(1, 7), pixelOf(1, 9.5), pixelOf(9, 9.5), pixelOf(9, 7)});
  EXPECT_THAT(selected, ElementsAre(78, 86, 89, 97));
}

TEST_F(RegionsOfGrid, PixelRatioScalesTheBrush)
{
  widget->SetBrushRadius(0.6 * pixelsOfUnit());
  widget->SetPixelRatio(2);
  mouse().click(pixelOf(5, 4));
  EXPECT_EQ(selected, gridBall(5, 4, 1.2));
  EXPECT_NEAR((outline().front() - pixelOf(5, 4)).norm(), 1.2 * pixelsOfUnit(), 1e-9);
}

TEST_F(RegionsOfGrid, ShiftAddsAndCtrlTakesAway)
{
  widget->SetBrushRadius(0.6 * pixelsOfUnit());
  mouse().click(pixelOf(2, 2));
  mouse().click(pixelOf(5, 4), {.shift = true});
  EXPECT_THAT(selected, ElementsAre(24, 49));
  mouse().click(pixelOf(2, 2), {.ctrl = true});
  EXPECT_THAT(selected, ElementsAre(49));
  mouse().click(pixelOf(8, 6));
  EXPECT_THAT(selected, ElementsAre(74));
}

TEST_F(RegionsOfGrid, EscapeCancelsAStrokeAndTheRestOfItsDrag)
{
  selected = {1, 2, 3};
  mouse().press(pixelOf(2, 2));
  mouse().moveTo(pixelOf(5, 4));
  EXPECT_NE(selected, (std::vector<Index>{1, 2, 3}));
  mouse().key("Escape");
  EXPECT_EQ(selected, (std::vector<Index>{1, 2, 3}));
  mouse().moveTo(pixelOf(8, 4));
  mouse().release(pixelOf(8, 4));
  EXPECT_THAT(events, ElementsAre(kBegins, kMoves, kMoves, kCancels));
}

TEST_F(RegionsOfGrid, AStrokeGoesOnWhereTheSurfaceMovesMeanwhile)
{
  widget->SetBrushRadius(0.6 * pixelsOfUnit());
  auto moved = std::make_shared<Positions>(fixture.surface()->positions());
  moved->col(0).array() += 1;
  mouse().press(pixelOf(2, 2));
  widget->SetSurface(std::make_shared<const VisibleSurface>(fixture.surface()->movedTo(moved)));
  mouse().moveTo(pixelOf(4, 2));
  mouse().release(pixelOf(4, 2));
  EXPECT_THAT(events, ElementsAre(kBegins, kMoves, kMoves, kEnds));
  EXPECT_THAT(selected,
              testing::AllOf(testing::Contains(24), testing::Contains(25), testing::Not(testing::Contains(26))));
}

TEST_F(RegionsOfGrid, APressBesideTheSurfaceIsLeftToTheCamera)
{
  vtkNew<vtkHoldfastSurfaceCameraStyle> style;
  fixture.interactor().SetInteractorStyle(style);
  const auto cameraAfter = [this](const std::vector<DisplayPoint>& way) {
    mouse().drag(way);
    const double* eye = fixture.renderer().GetActiveCamera()->GetPosition();
    return Vector3(eye);
  };
  const Vector3 rest(fixture.renderer().GetActiveCamera()->GetPosition());
  EXPECT_EQ(cameraAfter({pixelOf(2, 2), pixelOf(4, 5)}), rest);
  EXPECT_THAT(events, Not(IsEmpty()));
  events.clear();
  EXPECT_NE(cameraAfter({{3, 3}, {60, 80}}), rest);
  EXPECT_THAT(events, IsEmpty());
}

TEST_F(RegionsOfGrid, TheBrushFollowsTheCursorAndVanishesWithIt)
{
  EXPECT_THAT(outline(), IsEmpty());
  mouse().moveTo(pixelOf(2, 2));
  ASSERT_THAT(outline(), Not(IsEmpty()));
  for (const DisplayPoint& corner : outline()) EXPECT_NEAR((corner - pixelOf(2, 2)).norm(), 24, 1e-9);
  mouse().moveTo(pixelOf(5, 2));
  EXPECT_NEAR((outline().front() - pixelOf(5, 2)).norm(), 24, 1e-9);
  EXPECT_EQ(fixture.window().GetCurrentCursor(), VTK_CURSOR_CROSSHAIR);
  mouse().leave();
  EXPECT_THAT(outline(), IsEmpty());
  EXPECT_EQ(fixture.window().GetCurrentCursor(), VTK_CURSOR_DEFAULT);
  mouse().moveTo(pixelOf(5, 2));
  widget->Off();
  EXPECT_THAT(outline(), IsEmpty());
  EXPECT_EQ(fixture.window().GetCurrentCursor(), VTK_CURSOR_DEFAULT);
}

TEST_F(RegionsOfGrid, HoveringEndsWhileTheCameraMoves)
{
  vtkNew<vtkHoldfastSurfaceCameraStyle> style;
  fixture.interactor().SetInteractorStyle(style);
  mouse().press({3, 3});
  // The style begins with this one, which it sees after the widget.
  mouse().moveTo({10, 3});
  mouse().moveTo({60, 80});
  EXPECT_THAT(outline(), IsEmpty());
  mouse().release({60, 80});
  mouse().moveTo({60, 81});
  EXPECT_NEAR((outline().front() - DisplayPoint(60, 81)).norm(), 24, 1e-9);
}

TEST_F(RegionsOfGrid, BracketsSizeTheBrushWithinItsLimits)
{
  EventLog changes(*widget, {vtkCommand::WidgetValueChangedEvent});
  mouse().moveTo(pixelOf(5, 2));
  mouse().key("bracketright");
  EXPECT_DOUBLE_EQ(widget->GetBrushRadius(), 24 * 1.2);
  EXPECT_NEAR((outline().front() - pixelOf(5, 2)).norm(), 24 * 1.2, 1e-9);
  mouse().key("bracketleft");
  mouse().key("bracketleft");
  EXPECT_DOUBLE_EQ(widget->GetBrushRadius(), 20);
  EXPECT_THAT(changes.events(), SizeIs(3));
  for (int k = 0; k < 20; ++k) mouse().key("bracketleft");
  EXPECT_EQ(widget->GetBrushRadius(), 4);
  widget->SetBrushRadius(1e9);
  EXPECT_EQ(widget->GetBrushRadius(), 300);
  EXPECT_EQ(widget->GetSideAngle(), 20);
}

TEST_F(RegionsOfGrid, TheCircleOfTheBrushIsHiddenWhileTheCameraMoves)
{
  vtkNew<vtkHoldfastSurfaceCameraStyle> style;
  style->SetSurface(fixture.surface());
  fixture.interactor().SetInteractorStyle(style);
  mouse().moveTo(pixelOf(5, 4));
  ASSERT_GT(outline().size(), 8U);
  const auto expectHiddenDuring = [this](const char* what, auto press, auto release) {
    SCOPED_TRACE(what);
    (mouse().*press)(pixelOf(5, 4), {});
    mouse().moveTo(pixelOf(5.5, 4));
    mouse().moveTo(pixelOf(6, 4));
    EXPECT_THAT(outline(), IsEmpty());
    (mouse().*release)(pixelOf(6, 4), {});
    mouse().moveTo(pixelOf(5, 4));
    EXPECT_GT(outline().size(), 8U) << "it comes back";
  };
  using test::Mouse;
  expectHiddenDuring("a rotation", &Mouse::rightPress, &Mouse::rightRelease);
  expectHiddenDuring("a shift", &Mouse::middlePress, &Mouse::middleRelease);
}

}  // namespace
}  // namespace holdfast
