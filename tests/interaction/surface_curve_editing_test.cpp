#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkRenderWindow.h>

#include "interaction/drawn_curve.h"

namespace holdfast {
namespace {

using test::CurveOnGrid;
using test::kBegins;
using test::kCancels;
using test::kChanges;
using test::kEnds;
using test::kMoves;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

TEST_F(CurveOnGrid, PlacesOfAClosedCurveCanBeDragged)
{
  click({24, 29, 73});
  mouse().key("Return");
  events.clear();
  mouse().drag({fixture.pixelOfVertex(29), fixture.pixelOfVertex(30), fixture.pixelOfVertex(41)});
  EXPECT_THAT(widget->GetPlaces(), ElementsAre(24, 41, 73));
  EXPECT_EQ(widget->GetPath(), closedThrough({24, 41, 73}));
  EXPECT_THAT(events, ElementsAre(kBegins, kMoves, kChanges, kMoves, kChanges, kEnds));
  EXPECT_THAT(told, ElementsAre(24, 41, 73));
}

TEST_F(CurveOnGrid, ADragFromTheLineOfAClosedCurvePutsOneMorePlace)
{
  click({24, 29, 73});
  mouse().key("Return");
  events.clear();
  mouse().drag({fixture.pixelOfVertex(27), fixture.pixelOfVertex(16)});
  EXPECT_THAT(widget->GetPlaces(), ElementsAre(24, 16, 29, 73));
  EXPECT_THAT(events, ElementsAre(kBegins, kChanges, kMoves, kChanges, kEnds));
  // Beside the line nothing happens.
  events.clear();
  mouse().drag({fixture.pixelOfVertex(90), fixture.pixelOfVertex(92)});
  EXPECT_THAT(events, IsEmpty());
}

TEST_F(CurveOnGrid, ADragIsTakenBackByEscapeAndWhereTheWidgetGoes)
{
  click({24, 29, 73});
  mouse().key("Return");
  for (const bool byKey : {true, false}) {
    events.clear();
    mouse().press(fixture.pixelOfVertex(27));
    mouse().moveTo(fixture.pixelOfVertex(16));
    byKey ? mouse().key("Escape") : widget->Off();
    EXPECT_THAT(widget->GetPlaces(), ElementsAre(24, 29, 73));
    EXPECT_TRUE(widget->IsClosed());
    EXPECT_EQ(events.back(), kCancels);
    const std::size_t count = events.size();
    mouse().moveTo(fixture.pixelOfVertex(17));
    mouse().release(fixture.pixelOfVertex(17));
    EXPECT_THAT(events, SizeIs(count));
  }
}

TEST_F(CurveOnGrid, BackspaceTakesThePlaceUnderTheCursorFromAClosedCurve)
{
  click({24, 29, 62, 57});
  mouse().key("Return");
  mouse().moveTo(fixture.pixelOfVertex(29));
  EXPECT_EQ(fixture.window().GetCurrentCursor(), VTK_CURSOR_HAND);
  mouse().key("BackSpace");
  EXPECT_THAT(widget->GetPlaces(), ElementsAre(24, 62, 57));
  EXPECT_EQ(widget->GetPath(), closedThrough({24, 62, 57}));
  EXPECT_TRUE(widget->IsClosed());
  mouse().key("BackSpace");
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
  EXPECT_EQ(events.back(), kEnds);
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
  vtkNew<vtkHoldfastSurfaceCurveWidget> apart;
  EXPECT_FALSE(apart->SetPlaces({24, 29, 73}));
  apart->SetSurface(fixture.surface());
  EXPECT_FALSE(apart->SetPlaces({24, 29, 73}));
  apart->SetRegions(std::make_shared<VertexRegions>(fixture.model().mesh, fixture.model().solverMesh));
  EXPECT_TRUE(apart->SetPlaces({24, 29, 73}));
  EXPECT_TRUE(apart->Close());
  EXPECT_EQ(apart->GetPath(), closedThrough({24, 29, 73}));
  EXPECT_EQ(apart->GetSurfaceCurveRepresentation()->VertexAt({200, 150}), -1);
}

TEST_F(CurveOnGrid, VtksWaysToNodesKeepToVertices)
{
  EXPECT_EQ(curve().AddNodeAtWorldPosition(2.2, 1.9, 0.3), 1);
  DisplayPoint pixel = fixture.pixelOfVertex(29);
  EXPECT_EQ(curve().AddNodeAtDisplayPosition(pixel.data()), 1);
  EXPECT_EQ(curve().AddNodeAtDisplayPosition(static_cast<int>(pixel.x()), static_cast<int>(pixel.y())), 0);
  EXPECT_EQ(curve().AddNodeAtWorldPosition(7.1, 6, 0), 1);
  EXPECT_THAT(widget->GetPlaces(), ElementsAre(24, 29, 73));
  double place[3] = {7, 5, 0};
  EXPECT_EQ(curve().SetNthNodeWorldPosition(1, place), 1);
  pixel = fixture.pixelOfVertex(72);
  EXPECT_EQ(curve().SetNthNodeDisplayPosition(2, pixel.data()), 1);
  EXPECT_EQ(curve().SetNthNodeDisplayPosition(3, pixel.data()), 0);
  EXPECT_THAT(widget->GetPlaces(), ElementsAre(24, 62, 72));
  pixel = fixture.pixelOfVertex(62);
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

}  // namespace
}  // namespace holdfast
