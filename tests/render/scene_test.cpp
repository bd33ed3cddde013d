#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <holdfast/widgets/camera/camera_state.h>
#include <holdfast/widgets/scene/scene.h>

#include "render/compare_pictures.h"
#include "render/drawn_window.h"
#include "support/meshes.h"
#include "support/point_constraints.h"

namespace holdfast {
namespace {

constexpr PictureSize kSmall{320, 240};

/// A thick slab held at one end; the other is lifted, one point of it twice and to different places.
struct Bent {
  Model model = makeModel(test::box({6, 2, 1}, 8), "slab");
  DeformResult deformation = bend();

  [[nodiscard]] DeformResult bend() const
  {
    const Eigen::VectorXd x = model.mesh.positions.col(0);
    std::vector<Index> held;
    std::vector<Index> lifted;
    for (Index v = 0; v < x.size(); ++v) {
      if (x[v] == x.minCoeff()) held.push_back(v);
      if (x[v] == x.maxCoeff()) lifted.push_back(v);
    }
    ConstraintList list = test::listOf({test::hold(held), test::moveBy(AtVertex{lifted.front()}, {0, 0, 1.5}),
                                        test::moveBy(AtVertex{lifted.back()}, {0, 0.4, 1.5}),
                                        test::moveBy(AtVertex{lifted.back()}, {0, 0.4, 2.2})});
    NoProgress progress;
    return deform(model, list, "constraints", {}, progress);
  }
};

Scene sceneOf(const Bent& bent, ColorBy colorBy)
{
  return {bent.model, bent.deformation, {kSmall, colorBy, Legend::Hidden, ""}};
}

Picture drawnScene(const Scene& scene)
{
  return draw(scene, "picture");
}

/// With the control that another camera is told apart.
std::string differenceOfScene(const Scene& scene)
{
  return test::differenceFromBaseline(*scene.meshRenderer().GetActiveCamera(), [&] { return drawnScene(scene); });
}

std::string differenceOfBentSlab(ColorBy colorBy)
{
  const Bent bent;
  return differenceOfScene(sceneOf(bent, colorBy));
}

TEST(Scene, BentSlabInOneColor)
{
  EXPECT_EQ(differenceOfBentSlab(ColorBy::None), "");
}

TEST(Scene, BentSlabByDisplacement)
{
  EXPECT_EQ(differenceOfBentSlab(ColorBy::Displacement), "");
}

TEST(Scene, BentSlabByConstraintResidual)
{
  EXPECT_EQ(differenceOfBentSlab(ColorBy::ConstraintResidual), "");
}

TEST(Scene, BentSlabByDetail)
{
  EXPECT_EQ(differenceOfBentSlab(ColorBy::Detail), "");
}

TEST(Scene, TwistedBarByAngle)
{
  const Model model = makeModel(test::box({1, 1, 6}, 12), "bar");
  std::vector<Index> foot;
  std::vector<Index> top;
  for (Index v = 0; v < model.mesh.vertexCount(); ++v) {
    if (model.mesh.positions(v, 2) == 0) foot.push_back(v);
    if (model.mesh.positions(v, 2) == 6) top.push_back(v);
  }
  const ConstraintList list{
      "",
      {{"foot", true, FixedConstraint{{VertexIds{foot}}}},
       {"top", true,
        HandleConstraint{{VertexIds{top}}, AxisRotation{Vector3::UnitZ(), 450, {}}, Vector3::Zero(), {}}}}};
  NoProgress progress;
  const DeformResult deformation = deform(model, list, "constraints", {}, progress);
  const Scene scene(model, deformation, {kSmall, ColorBy::Angle, Legend::Shown, "mm"});
  EXPECT_EQ(test::textsIn(scene.window()),
            (std::vector<std::string>{"2 met", "rotation angle\n[degrees]", "0", "90", "180", "270", "360", "450"}));
  test::hideTexts(scene.window());
  EXPECT_EQ(differenceOfScene(scene), "");
}

/// A slab that is held in the middle and turned at both ends, each about an axis of its own.
struct Twisted {
  Model model = makeModel(test::box({6, 2, 1}, 8), "slab");
  DeformResult deformation = twist();

  [[nodiscard]] DeformResult twist() const
  {
    NoProgress progress;
    const ConstraintList list{
        "",
        {{"middle", true, FixedConstraint{{at(3)}}},
         {"left", true, HandleConstraint{{at(0)}, AxisRotation{Vector3::UnitY(), 50, {}}, Vector3::Zero(), {}}},
         {"right", true, HandleConstraint{{at(6)}, AxisRotation{Vector3::UnitX(), -140, {}}, Vector3::Zero(), {}}}}};
    return deform(model, list, "constraints", {}, progress);
  }

  [[nodiscard]] VertexIds at(double x) const
  {
    VertexIds section;
    for (Index v = 0; v < model.mesh.vertexCount(); ++v)
      if (model.mesh.positions(v, 0) == x) section.ids.push_back(v);
    return section;
  }

  [[nodiscard]] Picture drawn(const std::optional<Coloring>& other = std::nullopt) const
  {
    Scene scene(model, deformation, {kSmall, ColorBy::Rotation, Legend::Shown, ""});
    if (other) scene.contents().color(other);
    test::hideTexts(scene.window());
    return drawnScene(scene);
  }
};

TEST(Scene, TwistedSlabByRotation)
{
  const Twisted slab;
  const Scene scene(slab.model, slab.deformation, {kSmall, ColorBy::Rotation, Legend::Shown, ""});
  EXPECT_THAT(test::textsIn(scene.window()), testing::Contains("rotation |q|\n[rad]"));
  test::hideTexts(scene.window());
  EXPECT_EQ(differenceOfScene(scene), "");
}

TEST(Scene, SmoothSurfacesHaveNoEdges)
{
  const Model model = makeModel(test::icosphere(3), "sphere");
  NoProgress progress;
  const DeformResult deformation = deform(
      model, test::listOf({test::hold({0}), test::moveBy(AtVertex{40}, {0, 0, 0.5})}), "constraints", {}, progress);
  const Scene scene(model, deformation, {kSmall, ColorBy::Displacement, Legend::Hidden, ""});
  EXPECT_EQ(differenceOfScene(scene), "");
}

/// The places along the edges of the box from 0 to `size` that the eye sees and that are drawn without a dark line.
int gapsInEdges(const Scene& scene, const Vector3& size, const Picture& picture)
{
  constexpr int kDark = 120;
  constexpr int kSamples = 150;
  const Vector3 eye(scene.meshRenderer().GetActiveCamera()->GetPosition());
  const auto isDarkNear = [&](const Vector3& pixel) {
    for (int y = static_cast<int>(pixel.y()) - 1; y <= static_cast<int>(pixel.y()) + 1; ++y)
      for (int x = static_cast<int>(pixel.x()) - 1; x <= static_cast<int>(pixel.x()) + 1; ++x)
        if (picture.pixels[3 * (static_cast<std::size_t>(y) * picture.size.width + x)] < kDark) return true;
    return false;
  };
  int gaps = 0;
  for (int axis = 0; axis < 3; ++axis)
    for (const int corner : {0, 1, 2, 3}) {
      const int b = (axis + 1) % 3;
      const int c = (axis + 2) % 3;
      Vector3 from = Vector3::Zero();
      from[b] = (corner & 1) != 0 ? size[b] : 0;
      from[c] = (corner & 2) != 0 ? size[c] : 0;
      const auto isSeen = [&](int face) { return from[face] == 0 ? eye[face] < 0 : eye[face] > size[face]; };
      if (!isSeen(b) && !isSeen(c)) continue;
      for (int k = 0; k <= kSamples; ++k) {
        Vector3 place = from;
        place[axis] = k * size[axis] / kSamples;
        if (!isDarkNear(toDisplay(scene.meshRenderer(), place) / scene.pixelRatio())) ++gaps;
      }
    }
  return gaps;
}

TEST(Scene, EdgesOfFacesAreWholeFromWhereverTheyAreSeen)
{
  const Vector3 size(4, 1, 3);
  const Model model = makeModel(test::box(size, 2), "box");
  Scene scene(model, deform(model, test::listOf({test::hold({0})})), {kSmall, ColorBy::None, Legend::Hidden, ""});
  scene.contents().setMarks({});
  scene.contents().setRestGhost(RestGhost::Hidden);
  vtkCamera& camera = *scene.meshRenderer().GetActiveCamera();
  const auto gapsFrom = [&](const Vector3& direction) {
    const Vector3 eye = size / 2 + 24 * direction.normalized();
    camera.SetFocalPoint(2, 0.5, 1.5);
    camera.SetPosition(eye.data());
    camera.SetViewUp(0, 0, 1);
    scene.meshRenderer().ResetCameraClippingRange();
    return gapsInEdges(scene, size, drawnScene(scene));
  };
  for (const bool isParallel : {false, true}) {
    camera.SetParallelProjection(isParallel);
    camera.SetParallelScale(3);
    // Along the second and third ones a face is seen from its edge.
    for (const Vector3& direction : {Vector3(1, -1, 0.7), Vector3(0.28, -1, 0.3), Vector3(0.5, -0.2, 0.19)})
      EXPECT_EQ(gapsFrom(direction), 0) << direction.transpose() << ", parallel: " << isParallel;
  }
  scene.mesh().edges().VisibilityOff();
  EXPECT_GT(gapsFrom({1, -1, 0.7}), 100) << "the control";
}

TEST(Scene, SamePixelsAndBytesOnEveryRun)
{
  const Bent bent;
  const Picture first = drawnScene(Scene(bent.model, bent.deformation, {kSmall, ColorBy::Detail, Legend::Shown, "mm"}));
  const Picture second =
      drawnScene(Scene(bent.model, bent.deformation, {kSmall, ColorBy::Detail, Legend::Shown, "mm"}));
  EXPECT_EQ(first.pixels, second.pixels);
  EXPECT_EQ(toPng(first, "first"), toPng(second, "second"));
}

TEST(Scene, LegendTakesRoomAndOnlyWhereThereIsSome)
{
  const Bent bent;
  const auto share = [&](const PictureSize& size) {
    const Scene shown(bent.model, bent.deformation, {size, ColorBy::Displacement, Legend::Shown, "mm"});
    const Scene hidden(bent.model, bent.deformation, {size, ColorBy::Displacement, Legend::Hidden, "mm"});
    return test::shareOfOtherPixels(drawnScene(shown), drawnScene(hidden));
  };
  EXPECT_GT(share(kSmall), 0.05);
  EXPECT_EQ(share({kLeastLegendWidth - 1, 240}), 0);
}

TEST(Scene, SmallestPictureCanBeDrawn)
{
  const Bent bent;
  const Scene scene(bent.model, bent.deformation,
                    {{kLeastPictureSide, kLeastPictureSide}, ColorBy::Displacement, Legend::Shown, ""});
  EXPECT_EQ(drawnScene(scene).pixels.size(), 3U * kLeastPictureSide * kLeastPictureSide);
}

/// The bent slab with one value everywhere, on a scale that a user has typed.
Picture drawnWithValue(const Bent& bent, double value, double low, double high, int bands)
{
  Scene scene = sceneOf(bent, ColorBy::None);
  const auto vertices = static_cast<std::size_t>(bent.model.mesh.vertexCount());
  Coloring coloring = withRange({std::vector<double>(vertices, value), {}}, FixedRange{low, high});
  coloring.scale.bands = bands;
  scene.contents().color(coloring);
  return drawnScene(scene);
}

TEST(Scene, AFieldThatIsWhereTwoBandsMeetHasNoStripes)
{
  const Bent bent;
  for (const int bands : {2, 4, 10, 64})
    EXPECT_EQ(drawnWithValue(bent, 0, -1, 1, bands).pixels, drawnWithValue(bent, 0.5 / bands, -1, 1, bands).pixels)
        << bands;
  for (const double border : {1.0, 2.0, 4.0})
    EXPECT_EQ(drawnWithValue(bent, border, 0, 5, 5).pixels, drawnWithValue(bent, border + 0.5, 0, 5, 5).pixels)
        << border;
}

TEST(Scene, ValuesAtTheEndsOfARangeAreInside)
{
  const Bent bent;
  EXPECT_EQ(drawnWithValue(bent, 0, 0, 5, 5).pixels, drawnWithValue(bent, 0.5, 0, 5, 5).pixels);
  EXPECT_EQ(drawnWithValue(bent, 5, 0, 5, 5).pixels, drawnWithValue(bent, 4.5, 0, 5, 5).pixels);
  EXPECT_NE(drawnWithValue(bent, 5.1, 0, 5, 5).pixels, drawnWithValue(bent, 4.5, 0, 5, 5).pixels);
  EXPECT_NE(drawnWithValue(bent, -0.1, 0, 5, 5).pixels, drawnWithValue(bent, 0.5, 0, 5, 5).pixels);
}

// What the comparison must not let pass.

TEST(ComparisonMustFail, ForAnotherColorMap)
{
  const Bent bent;
  for (const ColorBy colorBy : {ColorBy::ConstraintResidual, ColorBy::Displacement, ColorBy::Detail}) {
    Scene scene = sceneOf(bent, colorBy);
    const Picture right = drawnScene(scene);
    auto coloring = coloringOf(bent.model, bent.deformation, colorBy, "");
    coloring->scale.map = ColorMap::BlueGreyYellow;
    scene.contents().color(coloring);
    EXPECT_GT(test::shareOfOtherPixels(right, drawnScene(scene)), 100 * test::kLargestShareOfOtherPixels);
  }
}

TEST(ComparisonMustFail, ForOneComponentInThePlaceOfTheRotation)
{
  const Twisted slab;
  auto component = coloringOf(slab.model, slab.deformation, ColorBy::Rotation, "");
  for (std::size_t v = 0; v < component->values.size(); ++v)
    component->values[v] = std::abs(slab.deformation.rotations(slab.model.solverMesh.weld.unknownOf[v], 0));
  EXPECT_GT(test::shareOfOtherPixels(slab.drawn(), slab.drawn(component)), 100 * test::kLargestShareOfOtherPixels);
}

TEST(ComparisonMustFail, ForOnePercentOfScale)
{
  const Bent bent;
  Scene scene = sceneOf(bent, ColorBy::Displacement);
  const Picture right = drawnScene(scene);
  scene.mesh().setPositions(1.01 * bent.deformation.positions);
  EXPECT_GT(test::shareOfOtherPixels(right, drawnScene(scene)), 5 * test::kLargestShareOfOtherPixels);
}

TEST(ComparisonMustFail, ForAnotherSize)
{
  EXPECT_EQ(
      test::shareOfOtherPixels({{4, 3}, std::vector<unsigned char>(36)}, {{3, 4}, std::vector<unsigned char>(36)}), 1);
}

TEST(ComparisonMustFail, WithoutABaseline)
{
  const Picture picture{{2, 1}, std::vector<unsigned char>(6, 128)};
  EXPECT_NE(test::differenceFromBaseline(picture).find("there is no baseline"), std::string::npos);
}

}  // namespace
}  // namespace holdfast
