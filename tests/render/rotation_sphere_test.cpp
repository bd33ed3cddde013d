
#include <gtest/gtest.h>
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkMapper.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>
#include <vtkScalarsToColors.h>

#include <holdfast/geometry/rotation_log.h>
#include <holdfast/widgets/rotation_sphere/rotation_sphere.h>

#include "render/compare_pictures.h"
#include "render/drawn_window.h"
#include "support/meshes.h"
#include "widgets/sphere_place.h"

namespace holdfast {
namespace {

constexpr PictureSize kSphereSize{360, 320};

DeformResult deformed(const Model& model, const ConstraintList& list)
{
  NoProgress progress;
  return deform(model, list, "constraints", {}, progress);
}

HandleConstraint rotated(std::vector<Index> vertices, const Vector3& axis, double degrees)
{
  return {{VertexIds{std::move(vertices)}}, AxisRotation{axis, degrees, {}}, Vector3::Zero(), {}};
}

/// A sheet of 13 x 13 vertices: one corner stays, two others turn about different axes.
struct Sheet {
  Model model = makeModel(test::grid(12, 12), "sheet");
  DeformResult deformation = deformed(model, {"",
                                              {{"corner", true, FixedConstraint{{VertexIds{{0, 1, 13}}}}},
                                               {"right", true, rotated({11, 12, 25}, {0, 1, 0}, 130)},
                                               {"far", true, rotated({156, 157, 143}, {1, 0, 0}, 90)}}});
};

/// A bar of which one end makes `degrees` about its length.
struct Bar {
  explicit Bar(double degrees)
  {
    std::vector<Index> foot;
    std::vector<Index> top;
    for (Index v = 0; v < model.mesh.vertexCount(); ++v) {
      if (model.mesh.positions(v, 2) == 0) foot.push_back(v);
      if (model.mesh.positions(v, 2) == 6) top.push_back(v);
    }
    deformation = deformed(model, {"",
                                   {{"foot", true, FixedConstraint{{VertexIds{foot}}}},
                                    {"top", true, rotated(top, Vector3::UnitZ(), degrees)}}});
  }

  Model model = makeModel(test::box({1, 1, 6}, 12), "bar");
  DeformResult deformation;
};

/// A sphere in a window, with a deformation.
struct Shown {
  Shown(const Model& model, const DeformResult& deformation)
  {
    sphere.addTo(window.renderer());
    sphere.show(placeRotations(model, deformation, nullptr));
    sphere.setColoring(coloringOf(model, deformation, ColorBy::Angle, ""));
    sphere.fitCamera();
    test::hideTexts(window.window());
  }

  [[nodiscard]] std::string differenceFromBaseline() const
  {
    return test::differenceFromBaseline(*window.renderer().GetActiveCamera(), [this] { return window.drawn(); });
  }

  test::OffscreenWindow window{kSphereSize};
  RotationSphere sphere;
};

TEST(RotationSphere, TwoHandlesAndACorner)
{
  const Sheet sheet;
  const Shown shown(sheet.model, sheet.deformation);
  EXPECT_EQ(shown.differenceFromBaseline(), "");
}

TEST(RotationSphere, MoreThanAWholeTurn)
{
  const Bar bar(720);
  Shown shown(bar.model, bar.deformation);
  shown.sphere.mark(bar.model.mesh.vertexCount() - 1);
  EXPECT_EQ(shown.differenceFromBaseline(), "");
}

TEST(RotationSphere, OnADarkGroundWithSmallAngles)
{
  const Bar bar(30);
  Shown shown(bar.model, bar.deformation);
  SphereLook look;
  look.background = {0.13, 0.14, 0.16};
  look.shell = {0.20, 0.215, 0.24};
  look.ink = {0.90, 0.92, 0.94};
  shown.sphere.setLook(look);
  test::hideTexts(shown.window.window());
  EXPECT_EQ(shown.differenceFromBaseline(), "");
}

TEST(RotationSphere, PointsAreTheQuaternionsOfTheirVertices)
{
  const Sheet sheet;
  const Shown shown(sheet.model, sheet.deformation);
  ASSERT_EQ(shown.sphere.placed().vertices->vertexOf.size(), 169);
  ASSERT_EQ(shown.sphere.placed().drawn.size(), 169);
  auto& mapper = dynamic_cast<vtkPolyDataMapper&>(*shown.sphere.points().GetMapper());
  for (std::size_t k = 0; k < 169; ++k) {
    const Index unknown = sheet.model.solverMesh.weld.unknownOf[shown.sphere.placed().vertices->vertexOf[k]];
    // The plane of the axes is that of x and y here.
    const Eigen::Quaterniond rotation = rotationExp(sheet.deformation.rotations.row(unknown).transpose());
    const Vector3 drawn(mapper.GetInput()->GetPoint(static_cast<vtkIdType>(k)));
    EXPECT_EQ(drawn, shown.sphere.placed().places[k]);
    EXPECT_NEAR((drawn - Vector3(rotation.x(), rotation.y(), rotation.w())).norm(), 0, 1e-14) << k;
  }
}

TEST(RotationSphere, PointsHaveTheColorsOfTheMesh)
{
  const Sheet sheet;
  const Shown shown(sheet.model, sheet.deformation);
  const auto coloring = coloringOf(sheet.model, sheet.deformation, ColorBy::Angle, "");
  vtkMapper& mapper = *shown.sphere.points().GetMapper();
  for (const Index vertex : {0, 60, 156}) {
    const Color expected = colorOf(coloring->scale, coloring->values[vertex]);
    const unsigned char* const drawn =
        mapper.GetLookupTable()->MapValue(shareOf(coloring->scale, coloring->values[vertex]));
    EXPECT_NEAR(drawn[0], 255 * expected.red, 1);
    EXPECT_NEAR(drawn[2], 255 * expected.blue, 1);
  }
}

TEST(RotationSphere, TheShownPointIsPicked)
{
  const Bar bar(200);
  const Shown shown(bar.model, bar.deformation);
  (void)shown.window.drawn();
  const Weld& weld = bar.model.solverMesh.weld;
  for (Index v = 0; v < bar.model.mesh.vertexCount(); v += 7) {
    const auto place = test::displayPlace(shown.sphere, v);
    ASSERT_TRUE(place);
    const auto picked = shown.sphere.pick(place->x(), place->y());
    ASSERT_TRUE(picked);
    // Several vertices may turn alike.
    const Vector3 q = bar.deformation.rotations.row(weld.unknownOf[v]).transpose();
    const Vector3 other = bar.deformation.rotations.row(weld.unknownOf[*picked]).transpose();
    EXPECT_NEAR((q - other).norm(), 0, 1e-9) << v;
  }
}

TEST(RotationSphere, NothingIsPickedBesideThePoints)
{
  const Sheet sheet;
  const Shown shown(sheet.model, sheet.deformation);
  (void)shown.window.drawn();
  EXPECT_FALSE(shown.sphere.pick(2, 2));
}

TEST(RotationSphere, NothingIsThereBeforeTheFirstRotations)
{
  test::OffscreenWindow window{kSphereSize};
  RotationSphere sphere;
  sphere.addTo(window.renderer());
  sphere.mark(0);
  (void)window.drawn();
  EXPECT_FALSE(test::displayPlace(sphere, 0));
  EXPECT_FALSE(sphere.pick(kSphereSize.width / 2.0, kSphereSize.height / 2.0));
  EXPECT_TRUE(sphere.placed().places.empty());
}

// What the comparison must not let pass.

TEST(SphereMustDiffer, ForAnotherRotation)
{
  const Bar bar(180);
  const Bar other(184);
  const Shown shown(bar.model, bar.deformation);
  Shown otherShown(other.model, other.deformation);
  const Picture right = shown.window.drawn();
  EXPECT_GT(test::shareOfOtherPixels(right, otherShown.window.drawn()), 5 * test::kLargestShareOfOtherPixels);
}

TEST(SphereMustDiffer, ForAMark)
{
  const Sheet sheet;
  Shown shown(sheet.model, sheet.deformation);
  const Picture right = shown.window.drawn();
  shown.sphere.mark(80);
  EXPECT_GT(test::shareOfOtherPixels(right, shown.window.drawn()), 5 * test::kLargestShareOfOtherPixels);
}

}  // namespace
}  // namespace holdfast
