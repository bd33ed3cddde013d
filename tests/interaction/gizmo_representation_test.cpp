#include <algorithm>
#include <cstdlib>
#include <sstream>

#include <gmock/gmock.h>
#include <vtkRenderWindow.h>
#include <vtkRendererCollection.h>
#include <vtkTextActor.h>

#include <holdfast/widgets/gizmo/gizmo_layout.h>

#include "holdfast/widgets/interaction/vtkHoldfastGizmoRepresentation.h"
#include "interaction/gizmo_fixture.h"

namespace holdfast {
namespace {

using test::GizmoFixture;
using test::placeOnArrow;
using test::placeOnGizmo;
using testing::HasSubstr;

std::vector<int> bytesOf(const Color& color)
{
  return {static_cast<int>(255 * color.red), static_cast<int>(255 * color.green), static_cast<int>(255 * color.blue)};
}

/// Without a widget: in the window, and nothing but a renderer knows of it.
struct GizmoDrawn : testing::Test {
  GizmoFixture fixture;
  vtkNew<vtkHoldfastGizmoRepresentation> gizmo;

  GizmoDrawn()
  {
    gizmo->SetPixelSize(test::kGizmoRadius);
    gizmo->SetFrame({1.5, 1, 0}, Eigen::Matrix3d::Identity());
    gizmo->SetRenderer(&fixture.renderer());
  }

  GizmoPart partAt(const DisplayPoint& place)
  {
    return static_cast<GizmoPart>(
        gizmo->ComputeInteractionState(static_cast<int>(place.x()), static_cast<int>(place.y())));
  }

  [[nodiscard]] int pixelsOf(GizmoPart part) const { return fixture.countPixels(bytesOf(gizmoColor(part)), 30); }
  [[nodiscard]] int highlightedPixels() const { return fixture.countPixels(bytesOf(kHighlightColor), 30); }

  void showDrag(GizmoPart part, const Vector3& translation, const DisplayPoint& cursor)
  {
    GizmoMotion motion;
    motion.translation = translation;
    gizmo->ShowDrag({part, gizmo->GetFrame(), Vector3::Zero(), motion}, "12.5 mm", cursor);
  }
};

TEST_F(GizmoDrawn, FollowsTheCameraWithoutBeingTold)
{
  ASSERT_GT(pixelsOf(GizmoPart::ArrowX), 50);
  for (const double azimuth : {0.0, 30.0, -20.0}) {
    fixture.renderer().GetActiveCamera()->Azimuth(azimuth);
    fixture.renderer().ResetCameraClippingRange();
    const std::vector<int> color = fixture.colorAt(placeOnArrow(*gizmo, 2));
    EXPECT_GT(color[2], color[0] + 40) << "the blue arrow, " << azimuth;
  }
}

TEST_F(GizmoDrawn, LiesInALayerOverAllAsLongAsItHasARenderer)
{
  vtkRenderWindow& window = fixture.window();
  EXPECT_EQ(window.GetRenderers()->GetNumberOfItems(), 2);
  EXPECT_EQ(gizmo->GetLayer()->GetLayer(), 1);
  EXPECT_EQ(gizmo->GetLayer()->GetInteractive(), 0);
  EXPECT_EQ(fixture.interactor().FindPokedRenderer(200, 150), &fixture.renderer());
  gizmo->SetRenderer(nullptr);
  EXPECT_EQ(window.GetRenderers()->GetNumberOfItems(), 1);
  EXPECT_EQ(pixelsOf(GizmoPart::ArrowX), 0);

  vtkNew<vtkRenderer> above;
  window.SetNumberOfLayers(4);
  above->SetLayer(3);
  window.AddRenderer(above);
  vtkNew<vtkHoldfastGizmoRepresentation> other;
  for (int k = 0; k < 3; ++k)
    for (vtkHoldfastGizmoRepresentation* one : {gizmo.Get(), other.Get()}) {
      one->SetRenderer(nullptr);
      one->SetRenderer(&fixture.renderer());
    }
  EXPECT_EQ(gizmo->GetLayer()->GetLayer(), 3);
  EXPECT_EQ(window.GetNumberOfLayers(), 4) << "layers do not pile up";
  EXPECT_GT(pixelsOf(GizmoPart::ArrowX), 50);
}

TEST_F(GizmoDrawn, TakesItsLayerAlongWhenItIsDeleted)
{
  {
    vtkNew<vtkHoldfastGizmoRepresentation> other;
    other->SetRenderer(&fixture.renderer());
    EXPECT_EQ(fixture.window().GetRenderers()->GetNumberOfItems(), 3);
  }
  EXPECT_EQ(fixture.window().GetRenderers()->GetNumberOfItems(), 2);
}

TEST_F(GizmoDrawn, IsNoReasonForCamerasToMove)
{
  fixture.renderer().AddViewProp(gizmo);
  fixture.renderer().ResetCamera();
  const double distance = fixture.renderer().GetActiveCamera()->GetDistance();
  gizmo->SetFrame({-100, 0, 0}, Eigen::Matrix3d::Identity());
  fixture.window().Render();
  fixture.renderer().ResetCamera();
  EXPECT_NEAR(fixture.renderer().GetActiveCamera()->GetDistance(), distance, 1e-9);
}

TEST_F(GizmoDrawn, IsNeitherDrawnNorHitWhileHidden)
{
  gizmo->SetPart(GizmoPart::ArrowX);
  ASSERT_EQ(partAt(placeOnArrow(*gizmo, 0)), GizmoPart::ArrowX);
  ASSERT_GT(pixelsOf(GizmoPart::ArrowZ), 50);
  gizmo->VisibilityOff();
  EXPECT_EQ(partAt(placeOnArrow(*gizmo, 0)), GizmoPart::None);
  EXPECT_EQ(pixelsOf(GizmoPart::ArrowZ), 0);
  EXPECT_EQ(gizmo->GetPart(), GizmoPart::None) << "nothing is active when it comes back";
  gizmo->VisibilityOn();
  EXPECT_GT(pixelsOf(GizmoPart::ArrowZ), 50);
}

TEST_F(GizmoDrawn, IsNeitherDrawnNorHitBehindTheEye)
{
  const Vector3 eye(fixture.renderer().GetActiveCamera()->GetPosition());
  gizmo->SetFrame(2 * eye - Vector3(1.5, 1, 0), Eigen::Matrix3d::Identity());
  EXPECT_EQ(partAt({200, 150}), GizmoPart::None);
  for (const GizmoPart part : {GizmoPart::ArrowX, GizmoPart::ArrowY, GizmoPart::ArrowZ}) EXPECT_EQ(pixelsOf(part), 0);
}

TEST_F(GizmoDrawn, ReachesTwiceAsFarOnADisplayOfTwiceTheResolution)
{
  const DisplayPoint center = placeOnGizmo(*gizmo, Vector3::Zero());
  const DisplayPoint ring = center + DisplayPoint(0, test::kGizmoRadius);
  const DisplayPoint arrow = 2 * placeOnArrow(*gizmo, 0) - center;
  EXPECT_EQ(partAt(ring), GizmoPart::ViewRing);
  gizmo->SetPixelRatio(2);
  EXPECT_NE(partAt(ring), GizmoPart::ViewRing);
  EXPECT_EQ(partAt(arrow), GizmoPart::ArrowX);
  gizmo->SetPixelSize(test::kGizmoRadius / 2);
  EXPECT_EQ(partAt(ring), GizmoPart::ViewRing);
}

TEST_F(GizmoDrawn, OffersNoRingsToWhatOnlyMoves)
{
  const DisplayPoint ring = placeOnGizmo(*gizmo, Vector3::Zero()) + DisplayPoint(0, test::kGizmoRadius);
  ASSERT_EQ(partAt(ring), GizmoPart::ViewRing);
  gizmo->SetPart(GizmoPart::RingX);
  gizmo->SetMotions(GizmoMotions::Moves);
  EXPECT_EQ(partAt(ring), GizmoPart::None);
  EXPECT_EQ(gizmo->GetPart(), GizmoPart::None);
  EXPECT_FALSE(gizmo->Offers(GizmoPart::RingX));
  EXPECT_TRUE(gizmo->Offers(GizmoPart::ArrowX));
}

TEST_F(GizmoDrawn, OffersWhatMovesAPlaneOrALineAlone)
{
  const auto offered = [&](GizmoMotions motions) {
    gizmo->SetMotions(motions);
    std::vector<GizmoPart> parts;
    for (int part = 0; part < kGizmoPartCount; ++part)
      if (gizmo->Offers(static_cast<GizmoPart>(part))) parts.push_back(static_cast<GizmoPart>(part));
    return parts;
  };
  EXPECT_EQ(offered(GizmoMotions::MovesAlongZ), std::vector{GizmoPart::ArrowZ});
  EXPECT_EQ(pixelsOf(GizmoPart::ArrowX), 0);
  EXPECT_GT(pixelsOf(GizmoPart::ArrowZ), 0);
  EXPECT_EQ(offered(GizmoMotions::MovesAcrossZ),
            (std::vector{GizmoPart::ArrowX, GizmoPart::ArrowY, GizmoPart::SquareZ}));
  EXPECT_GT(pixelsOf(GizmoPart::ArrowX), 50);
}

TEST_F(GizmoDrawn, AlignsItsAxesWithTheViewUnlessItIsDragged)
{
  gizmo->AlignToViewOn();
  fixture.window().Render();
  const Vector3 direction(fixture.renderer().GetActiveCamera()->GetDirectionOfProjection());
  EXPECT_LT((gizmo->GetFrame().axes.col(2) + direction).norm(), 1e-12);
  showDrag(GizmoPart::ArrowX, Vector3::Zero(), {0, 0});
  const Eigen::Matrix3d axes = gizmo->GetFrame().axes;
  fixture.renderer().GetActiveCamera()->Azimuth(40);
  fixture.window().Render();
  EXPECT_EQ(gizmo->GetFrame().axes, axes);
  gizmo->EndDrag();
  fixture.window().Render();
  EXPECT_GT((gizmo->GetFrame().axes - axes).norm(), 0.1);
}

TEST_F(GizmoDrawn, ShowsWhatIsDraggedAlone)
{
  ASSERT_GT(pixelsOf(GizmoPart::ArrowY), 50);
  ASSERT_LT(highlightedPixels(), 20);
  showDrag(GizmoPart::ArrowX, {0.5, 0, 0}, {0, 0});
  EXPECT_EQ(pixelsOf(GizmoPart::ArrowY), 0);
  EXPECT_EQ(pixelsOf(GizmoPart::ArrowZ), 0);
  EXPECT_GT(highlightedPixels(), 50);
  const std::vector<int> besideIt = fixture.colorAt(placeOnArrow(*gizmo, 2));
  EXPECT_LT(std::abs(besideIt[0] - besideIt[2]), 40) << "grey or black, and not yellow";
  EXPECT_EQ(gizmo->GetFrame().center, Vector3(2, 1, 0));
  gizmo->EndDrag();
  EXPECT_GT(pixelsOf(GizmoPart::ArrowY), 50);
  EXPECT_EQ(gizmo->GetFrame().center, Vector3(2, 1, 0));
}

TEST_F(GizmoDrawn, ADragAloneSetsTheFrameWhileItGoesOn)
{
  showDrag(GizmoPart::ArrowX, {0.5, 0, 0}, {0, 0});
  gizmo->SetFrame({7, 7, 7}, Eigen::Matrix3d::Identity());
  gizmo->SetMotions(GizmoMotions::Moves);
  EXPECT_EQ(gizmo->GetFrame().center, Vector3(2, 1, 0));
  EXPECT_EQ(gizmo->GetMotions(), GizmoMotions::MovesAndTurns);
  gizmo->EndDrag();
  gizmo->SetFrame({7, 7, 7}, Eigen::Matrix3d::Identity());
  EXPECT_EQ(gizmo->GetFrame().center, Vector3(7, 7, 7));
}

TEST_F(GizmoDrawn, ShowsAPartThatIsChosenAlsoFromItsEnd)
{
  vtkCamera& camera = *fixture.renderer().GetActiveCamera();
  camera.SetPosition(9, 1, 0);
  fixture.renderer().ResetCameraClippingRange();
  const int before = highlightedPixels();
  gizmo->SetPart(GizmoPart::ArrowX);
  EXPECT_GT(highlightedPixels(), before + 5);
}

/// Left, right, bottom and top of the label on the display.
std::array<double, 4> labelBox(vtkHoldfastGizmoRepresentation& gizmo)
{
  std::array<double, 4> box{};
  gizmo.GetLabelActor()->GetBoundingBox(gizmo.GetLayer(), box.data());
  const int* place = gizmo.GetLabelActor()->GetPositionCoordinate()->GetComputedDisplayValue(gizmo.GetLayer());
  return {box[0] + place[0], box[1] + place[0], box[2] + place[1], box[3] + place[1]};
}

TEST_F(GizmoDrawn, SaysHowFarAtTheCursorAndInsideTheViewport)
{
  fixture.renderer().SetViewport(0.25, 0.2, 0.9, 0.8);
  for (const double ratio : {1.0, 2.0})
    for (const DisplayPoint& cursor : {DisplayPoint(220, 140), DisplayPoint(100, 60), DisplayPoint(359, 239),
                                       DisplayPoint(100, 239), DisplayPoint(399, 0), DisplayPoint(-50, 400)}) {
      gizmo->SetPixelRatio(ratio);
      showDrag(GizmoPart::ArrowX, {0, 0, 0}, cursor);
      fixture.window().Render();
      ASSERT_TRUE(gizmo->GetLabelActor()->GetVisibility());
      const auto [left, right, bottom, top] = labelBox(*gizmo);
      EXPECT_GT(right - left, 40 * ratio);
      EXPECT_GE(left, 100) << cursor.transpose();
      EXPECT_LT(right, 360) << cursor.transpose();
      EXPECT_GE(bottom, 60) << cursor.transpose();
      EXPECT_LT(top, 240) << cursor.transpose();
    }
  showDrag(GizmoPart::ArrowX, {0, 0, 0}, {220, 140});
  fixture.window().Render();
  const auto [left, right, bottom, top] = labelBox(*gizmo);
  EXPECT_GT(left, 220);
  EXPECT_LT(left, 220 + 2 * 25);
  EXPECT_GT(bottom, 140);
}

TEST_F(GizmoDrawn, ItsLabelIsReadOnLightAndDark)
{
  for (const double shade : {0.0, 1.0}) {
    fixture.renderer().SetBackground(shade, shade, shade);
    showDrag(GizmoPart::ArrowX, {0, 0, 0}, {20, 20});
    fixture.window().Render();
    const auto [left, right, bottom, top] = labelBox(*gizmo);
    int least = 255;
    int most = 0;
    for (double x = left + 1; x < right; ++x) {
      const int value = fixture.colorAt({x, (bottom + top) / 2})[1];
      least = std::min(least, value);
      most = std::max(most, value);
    }
    EXPECT_LT(least, 80) << shade;
    EXPECT_GT(most, 190) << shade;
  }
}

TEST_F(GizmoDrawn, LeavesItsLabelToAWindowThatDrawsItsOwn)
{
  gizmo->LabelVisibilityOff();
  showDrag(GizmoPart::ArrowX, {0, 0, 0}, {220, 140});
  fixture.window().Render();
  EXPECT_FALSE(gizmo->GetLabelActor()->GetVisibility());
  EXPECT_EQ(gizmo->GetLabel(), "12.5 mm");
  EXPECT_EQ(gizmo->GetLabelPosition(), DisplayPoint(220, 140));
  gizmo->EndDrag();
  EXPECT_EQ(gizmo->GetLabel(), "");
}

TEST_F(GizmoDrawn, PrintsItsState)
{
  std::ostringstream text;
  gizmo->Print(text);
  EXPECT_THAT(text.str(), HasSubstr("PixelSize: 90"));
}

}  // namespace
}  // namespace holdfast
