#include <cmath>
#include <cstdlib>
#include <numbers>
#include <optional>

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPropCollection.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkTexture.h>

#include <holdfast/widgets/interaction/vtkHoldfastGizmoRepresentation.h>
#include <holdfast/widgets/scene/scene.h>

#include "render/compare_pictures.h"
#include "render/drawn_window.h"
#include "support/meshes.h"
#include "support/point_constraints.h"

namespace holdfast {
namespace {

constexpr PictureSize kPictureSize{360, 300};
constexpr double kPixels = 100;  // of the picture

/// A slab at rest with a gizmo at one of its ends.
struct GizmoScene {
  Model model = makeModel(test::box({6, 2, 1}, 8), "slab");
  Scene scene{model, atRest(model), {kPictureSize, ColorBy::None, Legend::Hidden, ""}};
  vtkNew<vtkHoldfastGizmoRepresentation> gizmo;

  GizmoScene()
  {
    gizmo->SetRenderer(&renderer());
    gizmo->SetPixelSize(kPixels);
    gizmo->SetPixelRatio(scene.pixelRatio());
    gizmo->SetFrame({4, 1, 0.5}, Eigen::Matrix3d::Identity());
    look(-35, 25);
  }

  static DeformResult atRest(const Model& model)
  {
    NoProgress progress;
    return deform(model, test::listOf({test::hold({0})}), "constraints", {}, progress);
  }

  [[nodiscard]] vtkRenderer& renderer() const { return scene.meshRenderer(); }

  /// From `azimuth` degrees about z and `elevation` degrees above, at the gizmo.
  void look(double azimuth, double elevation) const
  {
    constexpr double degree = std::numbers::pi / 180;
    const Vector3 back(std::cos(elevation * degree) * std::cos(azimuth * degree),
                       std::cos(elevation * degree) * std::sin(azimuth * degree), std::sin(elevation * degree));
    const Vector3 focus(3.6, 1, 0.5);
    const Vector3 eye = focus + 14 * back;
    vtkCamera& camera = *renderer().GetActiveCamera();
    camera.SetViewAngle(24);
    camera.SetFocalPoint(focus.data());
    camera.SetPosition(eye.data());
    camera.SetViewUp(0, 0, 1);
    camera.SetParallelScale(3);
    renderer().ResetCameraClippingRange();
  }

  Picture drawn() { return draw(scene, "picture"); }

  [[nodiscard]] std::string differenceFromBaseline()
  {
    test::hideTexts(scene.window());
    return test::differenceFromBaseline(*renderer().GetActiveCamera(), [this] { return drawn(); });
  }

  /// Drags a part from a place of the world to where it appears `moved` pixels further.
  void drag(GizmoPart part, const Vector3& from, const DisplayPoint& moved, Snap snap)
  {
    const DisplayPoint start = *toDisplay(DisplayTransform(renderer()), from);
    gizmo->SetPart(part);
    GizmoDrag drag = gizmo->NewDrag(start);
    const GizmoMotion motion = drag.to(start + moved, snap);
    gizmo->ShowDrag({part, gizmo->GetFrame(), drag.grabbed(), motion}, "", start);
  }
};

TEST(GizmoPicture, InPerspective)
{
  GizmoScene fixture;
  EXPECT_EQ(fixture.differenceFromBaseline(), "");
}

TEST(GizmoPicture, InParallelFromAbove)
{
  GizmoScene fixture;
  fixture.renderer().GetActiveCamera()->ParallelProjectionOn();
  fixture.look(-60, 62);
  fixture.gizmo->SetPart(GizmoPart::RingZ);
  EXPECT_EQ(fixture.differenceFromBaseline(), "");
}

TEST(GizmoPicture, AlongAnAxis)
{
  GizmoScene fixture;
  fixture.look(-90, 2);
  EXPECT_EQ(fixture.differenceFromBaseline(), "");
}

TEST(GizmoPicture, OfAnArrowThatIsDragged)
{
  GizmoScene fixture;
  fixture.drag(GizmoPart::ArrowZ, {4, 1, 1.5}, {0, 120}, Snap::On);
  EXPECT_EQ(fixture.differenceFromBaseline(), "");
}

TEST(GizmoPicture, OfARingThatIsDragged)
{
  GizmoScene fixture;
  fixture.drag(GizmoPart::RingZ, {4.7, 0.4, 0.5}, {70, 30}, Snap::On);
  EXPECT_EQ(fixture.differenceFromBaseline(), "");
}

TEST(GizmoPicture, OfTheOuterRingThatIsDragged)
{
  GizmoScene fixture;
  fixture.renderer().GetActiveCamera()->ParallelProjectionOn();
  fixture.drag(GizmoPart::ViewRing, {4, 1, 1.5}, {150, -90}, Snap::None);
  EXPECT_EQ(fixture.differenceFromBaseline(), "");
}

/// The mean place of the pixels that differ, in pixels of the window.
std::optional<DisplayPoint> middleOfDifference(const Picture& a, const Picture& b, int pixelRatio)
{
  DisplayPoint sum = DisplayPoint::Zero();
  int count = 0;
  for (std::size_t k = 0; k < a.pixels.size(); k += 3) {
    const bool isOther = std::abs(a.pixels[k + 2] - b.pixels[k + 2]) > 10;
    if (!isOther) continue;
    const auto pixel = static_cast<int>(k / 3);
    const int row = pixel / a.size.width;
    sum += DisplayPoint(pixel % a.size.width + 0.5, row + 0.5);
    ++count;
  }
  return count == 0 ? std::nullopt : std::optional<DisplayPoint>(sum / count * pixelRatio);
}

TEST(GizmoPicture, ShowsTheCenterWhereItIsAndOverTheSurface)
{
  GizmoScene fixture;
  for (const bool isParallel : {false, true})
    for (const Vector3& center : {Vector3(4, 1, 0.5), Vector3(3, 0.2, 0.3), Vector3(4.5, 2.5, -0.4)}) {
      SCOPED_TRACE(center.transpose());
      fixture.renderer().GetActiveCamera()->SetParallelProjection(isParallel);
      fixture.gizmo->ShowDrag({GizmoPart::Center, {center, Eigen::Matrix3d::Identity()}, {0, 0, 0}, {}}, "", {0, 0});
      fixture.gizmo->VisibilityOff();
      const Picture without = fixture.drawn();
      fixture.gizmo->VisibilityOn();
      const auto middle = middleOfDifference(fixture.drawn(), without, fixture.scene.pixelRatio());
      ASSERT_TRUE(middle) << "the slab hides it";
      const DisplayPoint expected = *toDisplay(DisplayTransform(fixture.renderer()), center);
      EXPECT_LT((*middle - expected).norm(), 0.4) << (*middle - expected).transpose();
    }
}

/// The letters of the gizmo, x first.
std::vector<vtkTextActor*> lettersOf(const vtkHoldfastGizmoRepresentation& gizmo)
{
  std::vector<vtkTextActor*> letters;
  vtkPropCollection& props = *gizmo.GetLayer()->GetViewProps();
  for (int k = 0; k < props.GetNumberOfItems(); ++k)
    if (auto* const letter = vtkTextActor::SafeDownCast(props.GetItemAsObject(k));
        letter != nullptr && letter != gizmo.GetLabelActor())
      letters.push_back(letter);
  return letters;
}

TEST(GizmoPicture, HasItsLettersBeyondTheTipsOfTheirArrows)
{
  GizmoScene fixture;
  const std::vector<vtkTextActor*> letters = lettersOf(*fixture.gizmo);
  ASSERT_EQ(letters.size(), 3u);
  const Picture all = fixture.drawn();
  const DisplayTransform view(fixture.renderer());
  const DisplayPoint center = *toDisplay(view, fixture.gizmo->GetFrame().center);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_EQ(letters[axis]->GetInput(), std::string(1, "xyz"[axis]));
    letters[axis]->GetTextProperty()->SetOpacity(0);
    const auto middle = middleOfDifference(fixture.drawn(), all, fixture.scene.pixelRatio());
    letters[axis]->GetTextProperty()->SetOpacity(1);
    ASSERT_TRUE(middle) << axis;
    const Vector3 along = fixture.gizmo->GetFrame().center + Vector3::Unit(axis);
    const DisplayPoint direction = (*toDisplay(view, along) - center).normalized();
    const DisplayPoint arm = (*middle - center) / fixture.scene.pixelRatio();
    EXPECT_NEAR(arm.normalized().dot(direction), 1, 0.02) << axis;
    EXPECT_GT(arm.norm(), 0.5 * kPixels) << axis;
    EXPECT_LT(arm.norm(), kPixels) << axis;
  }
}

TEST(GizmoPicture, IsTheSceneAloneWhileHidden)
{
  GizmoScene fixture;
  fixture.gizmo->VisibilityOff();
  const Picture hidden = fixture.drawn();
  fixture.gizmo->SetRenderer(nullptr);
  EXPECT_EQ(test::shareOfOtherPixels(hidden, draw(fixture.scene, "picture")), 0);
}

/// Returns when VTK drew each text of the gizmo as an image, which is loaded onto the graphics card then.
std::vector<vtkMTimeType> textTimes(const vtkHoldfastGizmoRepresentation& gizmo)
{
  std::vector<vtkMTimeType> times;
  for (vtkTextActor* const letter : lettersOf(gizmo)) times.push_back(letter->GetTexture()->GetInput()->GetMTime());
  return times;
}

TEST(Gizmo, MovesItsLettersWithoutDrawingThemAnew)
{
  GizmoScene fixture;
  // The first picture tells VTK the resolution.
  static_cast<void>(fixture.drawn());
  const Picture before = fixture.drawn();
  const std::vector<vtkMTimeType> times = textTimes(*fixture.gizmo);
  ASSERT_EQ(times.size(), 3u);
  fixture.gizmo->SetFrame({3.5, 1, 0.5}, Eigen::Matrix3d::Identity());
  EXPECT_GT(test::shareOfOtherPixels(before, fixture.drawn()), 0.01);
  EXPECT_EQ(textTimes(*fixture.gizmo), times);
  fixture.gizmo->SetPixelSize(2 * fixture.gizmo->GetPixelSize());
  static_cast<void>(fixture.drawn());
  EXPECT_NE(textTimes(*fixture.gizmo), times) << "larger letters";
}

// What the comparison must not let pass.

/// How much more of the picture is different than a comparison lets pass, after `change`.
template <class Change>
double excessAfter(Change change)
{
  GizmoScene fixture;
  const Picture right = fixture.drawn();
  change(fixture);
  return test::shareOfOtherPixels(right, fixture.drawn()) / test::kLargestShareOfOtherPixels;
}

TEST(GizmoComparisonMustFail, ForAnotherPartThatIsHighlighted)
{
  EXPECT_GT(excessAfter([](GizmoScene& fixture) { fixture.gizmo->SetPart(GizmoPart::SquareX); }), 5);
  EXPECT_GT(excessAfter([](GizmoScene& fixture) { fixture.gizmo->SetPart(GizmoPart::Center); }), 5);
}

TEST(GizmoComparisonMustFail, ForAxesThatAreTurnedByTwoDegrees)
{
  const Eigen::Matrix3d rotated = Eigen::AngleAxisd(std::numbers::pi / 90, Vector3::UnitZ()).matrix();
  EXPECT_GT(excessAfter([&](GizmoScene& fixture) { fixture.gizmo->SetFrame({4, 1, 0.5}, rotated); }), 5);
}

TEST(GizmoComparisonMustFail, ForTwoPercentOfSize)
{
  EXPECT_GT(excessAfter([](GizmoScene& fixture) { fixture.gizmo->SetPixelSize(1.02 * fixture.gizmo->GetPixelSize()); }),
            5);
}

}  // namespace
}  // namespace holdfast
