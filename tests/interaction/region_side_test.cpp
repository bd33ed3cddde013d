#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkCamera.h>

#include <holdfast/widgets/interaction/vtkHoldfastSurfaceCameraStyle.h>

#include "interaction/region_window.h"
#include "support/law_meshes.h"
#include "support/meshes.h"

namespace holdfast {
namespace {

using test::EventLog;
using test::kBegins;
using test::kEnds;
using test::RegionWindow;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

/// A box seen from its corner: three sides of 25 vertices each.
struct RegionsOfBox : testing::Test, RegionWindow {
  RegionsOfBox() : RegionWindow(test::merged(test::box({1, 1, 1}, 4), test::moved(test::box({1, 1, 1}, 4), {3, 0, 0})))
  {
    fixture.renderer().GetActiveCamera()->Azimuth(30);
    fixture.renderer().GetActiveCamera()->Elevation(30);
    fixture.renderer().ResetCamera();
    widget->SetShape(RegionShape::Side);
  }

  DisplayPoint onTop = fixture.pixelOf({0.55, 1, 0.45});
};

TEST_F(RegionsOfBox, AClickSelectsTheSide)
{
  const Positions& places = fixture.model().mesh.positions;
  // Wherever the box stands: its topmost vertices.
  const double top = places.col(1).maxCoeff();
  const Vector3 least = places.colwise().minCoeff();
  onTop = fixture.pixelOf({least.x() + 0.55, top, least.z() + 0.45});
  mouse().click(onTop);
  EXPECT_THAT(events, ElementsAre(kBegins, kEnds));
  EXPECT_THAT(selected, SizeIs(25));
  for (const Index vertex : selected) EXPECT_EQ(places(vertex, 1), top);
  mouse().click(onTop, {.ctrl = true});
  EXPECT_THAT(selected, IsEmpty());
}

TEST_F(RegionsOfBox, ADoubleClickSelectsTheConnectedPart)
{
  mouse().doubleClick(onTop);
  EXPECT_THAT(selected, SizeIs(fixture.model().mesh.vertexCount() / 2));
  EXPECT_THAT(events, ElementsAre(kBegins, kEnds, kBegins, kEnds));
  events.clear();
  fixture.interactor().SetEventInformation(static_cast<int>(onTop.x()), static_cast<int>(onTop.y()));
  fixture.interactor().InvokeEvent(vtkCommand::LeftButtonDoubleClickEvent);
  EXPECT_THAT(events, ElementsAre(kBegins, kEnds));
}

TEST_F(RegionsOfBox, ADragFromASideTurnsThePictureAndSelectsNothing)
{
  vtkNew<vtkHoldfastSurfaceCameraStyle> style;
  fixture.interactor().SetInteractorStyle(style);
  const Vector3 eye(fixture.renderer().GetActiveCamera()->GetPosition());
  mouse().drag({onTop, onTop + DisplayPoint(6, 0), onTop + DisplayPoint(30, 5)});
  EXPECT_THAT(events, IsEmpty());
  EXPECT_NE(Vector3(fixture.renderer().GetActiveCamera()->GetPosition()), eye);
  fixture.interactor().SetInteractorStyle(nullptr);
  mouse().drag({onTop, onTop + DisplayPoint(6, 0), onTop});
  EXPECT_THAT(events, IsEmpty()) << "the hand came back";
  // Four pixels of a display of high resolution are eight.
  widget->SetPixelRatio(2);
  mouse().drag({onTop, onTop + DisplayPoint(6, 0)});
  EXPECT_THAT(events, ElementsAre(kBegins, kEnds));
}

TEST_F(RegionsOfBox, BracketsChangeTheAngleOfASide)
{
  EventLog changes(*widget, {vtkCommand::WidgetValueChangedEvent});
  for (int k = 0; k < 14; ++k) mouse().key("bracketright");
  EXPECT_EQ(widget->GetSideAngle(), 90);
  EXPECT_THAT(changes.events(), SizeIs(14));
  mouse().key("bracketright");
  mouse().click(onTop);
  EXPECT_THAT(selected, SizeIs(fixture.model().mesh.vertexCount() / 2));
  for (int k = 0; k < 100; ++k) mouse().key("bracketright");
  EXPECT_EQ(widget->GetSideAngle(), 175);
  for (int k = 0; k < 100; ++k) mouse().key("bracketleft");
  EXPECT_EQ(widget->GetSideAngle(), 0);
  EXPECT_EQ(widget->GetBrushRadius(), 24);
}

/// A round surface, which bends little from face to face.
struct RegionsOfSphere : testing::Test, RegionWindow {
  RegionsOfSphere() : RegionWindow(test::icosphere(4)) { widget->SetShape(RegionShape::Side); }
};

TEST_F(RegionsOfSphere, TheKeyNMeasuresFromTheFaceThatIsClicked)
{
  EventLog changes(*widget, {vtkCommand::WidgetValueChangedEvent});
  const DisplayPoint middle(fixture.renderer().GetSize()[0] / 2, fixture.renderer().GetSize()[1] / 2);
  mouse().click(middle);
  EXPECT_THAT(selected, SizeIs(fixture.model().mesh.vertexCount())) << "from face to face";
  mouse().key("n");
  EXPECT_EQ(widget->GetBendFrom(), BendFrom::FirstFace);
  EXPECT_THAT(changes.events(), SizeIs(1));
  mouse().click(middle);
  EXPECT_FALSE(selected.empty());
  const Vector3 sight(fixture.renderer().GetActiveCamera()->GetViewPlaneNormal());
  for (const Index v : selected)
    EXPECT_GT(fixture.model().mesh.positions.row(v).normalized().dot(sight), std::cos(26 * std::numbers::pi / 180));
  mouse().key("n");
  mouse().click(middle);
  EXPECT_THAT(selected, SizeIs(fixture.model().mesh.vertexCount()));
  widget->SetShape(RegionShape::Brush);
  mouse().key("n");
  EXPECT_EQ(widget->GetBendFrom(), BendFrom::Neighbour) << "a brush has no sides";
}

}  // namespace
}  // namespace holdfast
