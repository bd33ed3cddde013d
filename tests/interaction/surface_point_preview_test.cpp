#include <utility>

#include <gtest/gtest.h>
#include <vtkCamera.h>

#include <holdfast/widgets/interaction/vtkHoldfastSurfacePointWidget.h>

#include "interaction/interaction_fixture.h"
#include "support/law_meshes.h"
#include "support/meshes.h"

namespace holdfast {
namespace {

struct PreviewFixture : test::InteractionFixture {
  explicit PreviewFixture(Mesh mesh) : InteractionFixture(std::move(mesh))
  {
    widget->SetSurface(surface());
    enable(*widget);
  }

  vtkNew<vtkHoldfastSurfacePointWidget> widget;
};

// The accent colour, and that of halos, in a picture.
const std::vector<int> kAccent{156, 43, 255};
const std::vector<int> kLight{250, 250, 250};

struct PreviewPicture : testing::Test {
  /// Pixels of the accent colour where a point at `place`, in the middle of the picture, is shown from `direction`.
  int accentOf(PreviewFixture& fixture, const Vector3& place, const SurfaceLocation& location, const Vector3& direction)
  {
    vtkCamera& camera = *fixture.renderer().GetActiveCamera();
    camera.SetFocalPoint(place.data());
    const Vector3 eye = place + 6 * direction.normalized();
    camera.SetPosition(eye.data());
    camera.OrthogonalizeViewUp();
    fixture.renderer().ResetCameraClippingRange();
    SurfacePick pick;
    pick.location = location;
    fixture.widget->SetPreview(&pick);
    return fixture.countPixels(kAccent, 30);
  }
};

TEST_F(PreviewPicture, OfAVisiblePointIsDrawnWholeFromAllSides)
{
  PreviewFixture fixture(test::icosphere(3));
  for (const Vector3& direction : {Vector3(0, 0, 1), Vector3(0.3, 0.2, 1), Vector3(0.8, 0.1, 0.5)}) {
    Index nearest = 0;
    (fixture.model().mesh.positions * direction).maxCoeff(&nearest);
    const Vector3 place = fixture.model().mesh.positions.row(nearest);
    // From straight above, and 70 degrees aslant.
    const int straight = accentOf(fixture, place, AtVertex{nearest}, place);
    const Vector3 aside = place.cross(Vector3(0.1, 1, 0.2)).normalized();
    const int aslant = accentOf(fixture, place, AtVertex{nearest}, 0.34 * place.normalized() + 0.94 * aside);
    EXPECT_GT(straight, 60);
    EXPECT_GT(aslant, 0.9 * straight);
    EXPECT_EQ(accentOf(fixture, place, AtVertex{nearest}, -place), 0) << "behind the sphere";
  }
}

TEST_F(PreviewPicture, OutlinesTheEdgeOrTheFace)
{
  PreviewFixture fixture(test::grid(4, 3));
  const auto accent = [&](const SurfaceLocation& location) {
    return accentOf(fixture, Vector3(1.5, 1.5, 0), location, {0, 0, 1});
  };
  const int ofVertex = accent(AtVertex{7});
  const int ofEdge = accent(AtEdge{6, 7, 0.5});
  const int ofFace = accent(AtFace{10, {0.3, 0.3, 0.4}});
  EXPECT_GT(ofEdge, ofVertex + 50);
  EXPECT_GT(ofFace, ofEdge + 100);
  EXPECT_GT(fixture.countPixels(kLight, 10), 100) << "halos";
  fixture.widget->HidePreview();
  EXPECT_EQ(fixture.countPixels(kAccent, 30), 0);
  EXPECT_EQ(fixture.countPixels(kLight, 10), 0);
}

TEST_F(PreviewPicture, WhatAnotherPartHidesOfTheOutlineIsFaint)
{
  // A plate over the right half of a larger one, of which a side passes below it.
  const Mesh above = test::moved(test::grid(2, 3), {2, 0, 0.5});
  PreviewFixture fixture(test::merged(test::triangle({0, 1.5, 0}, {4, 1.5, 0}, {0, 1.4, 0}), above));
  static_cast<void>(accentOf(fixture, {2, 1.5, 0}, AtEdge{0, 1, 0.9}, {0, 0, 1}));
  const std::vector<int> open = fixture.colorAt(fixture.pixelOf({1.5, 1.5, 0}));
  const std::vector<int> hidden = fixture.colorAt(fixture.pixelOf({2.6, 1.5, 0}));
  const std::vector<int> beside = fixture.colorAt(fixture.pixelOf({2.6, 1.8, 0}));
  EXPECT_NEAR(open[0], kAccent[0], 30);
  EXPECT_GT(hidden[2], beside[2] + 15) << "bluer than the plate";
  EXPECT_GT(hidden[1], kAccent[1] + 50) << "and far from the full colour";
}

TEST_F(PreviewPicture, IsLargerOnADisplayOfManyPixels)
{
  PreviewFixture fixture(test::grid(4, 3));
  const int once = accentOf(fixture, Vector3(1.5, 1.5, 0), AtEdge{6, 7, 0.5}, {0, 0, 1});
  fixture.widget->SetPixelRatio(2);
  const int twice = accentOf(fixture, Vector3(1.5, 1.5, 0), AtEdge{6, 7, 0.5}, {0, 0, 1});
  EXPECT_GT(twice, 1.6 * once);
}

}  // namespace
}  // namespace holdfast
