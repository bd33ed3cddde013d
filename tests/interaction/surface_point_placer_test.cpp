#include <gtest/gtest.h>

#include "holdfast/widgets/interaction/vtkHoldfastSurfacePointPlacer.h"
#include "interaction/interaction_fixture.h"
#include "support/meshes.h"

namespace holdfast {
namespace {

using test::InteractionFixture;

struct PlacerOnGrid : testing::Test {
  InteractionFixture fixture{test::grid(4, 3)};
  vtkNew<vtkHoldfastSurfacePointPlacer> placer;
  double world[3] = {7, 7, 7};
  double orient[9] = {};

  int place(const DisplayPoint& pixel)
  {
    double display[2] = {pixel.x(), pixel.y()};
    return placer->ComputeWorldPosition(&fixture.renderer(), display, world, orient);
  }
};

TEST_F(PlacerOnGrid, GivesPlaceAndWeightsOfWhatIsUnderThePixel)
{
  placer->SetSurface(fixture.surface());
  placer->SetKind(PickKind::Vertex);
  ASSERT_EQ(place(fixture.pixelOfVertex(6)), 1);
  EXPECT_EQ(Vector3(world), Vector3(1, 1, 0));
  ASSERT_TRUE(placer->GetLastPick());
  EXPECT_EQ(std::get<AtVertex>(placer->GetLastPick()->location).vertex, 6);
  EXPECT_EQ(orient[0] + orient[4] + orient[8], 3);
}

TEST_F(PlacerOnGrid, PlacesNothingBesideTheSurfaceOrWithoutOne)
{
  EXPECT_EQ(place(fixture.pixelOfVertex(6)), 0);
  placer->SetSurface(fixture.surface());
  EXPECT_EQ(place({1, 1}), 0);
  EXPECT_EQ(Vector3(world), Vector3(7, 7, 7));
  EXPECT_FALSE(placer->GetLastPick());
}

TEST_F(PlacerOnGrid, SnapsAsFarAsItsPixelsAndTheRatioReach)
{
  placer->SetSurface(fixture.surface());
  placer->SetSnapPixels(5);
  const DisplayPoint beside = fixture.pixelOfVertex(6) + DisplayPoint(8, 4);
  ASSERT_EQ(place(beside), 1);
  EXPECT_TRUE(std::holds_alternative<AtFace>(placer->GetLastPick()->location) ||
              std::holds_alternative<AtEdge>(placer->GetLastPick()->location));
  placer->SetPixelRatio(2);
  ASSERT_EQ(place(beside), 1);
  EXPECT_TRUE(std::holds_alternative<AtVertex>(placer->GetLastPick()->location));
}

}  // namespace
}  // namespace holdfast
