// The surfaces beside the mesh on which constraints keep points.

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/surface/guide_surface.h>
#include <holdfast/words/error.h>

#include "support/law_meshes.h"
#include "support/meshes.h"
#include "support/point_constraints.h"
#include "support/random.h"

namespace holdfast {
namespace {

using testing::HasSubstr;

TEST(GuideSurface, HasTheNearestPlaceAsFoot)
{
  const GuideSurface box(test::box({2, 2, 2}, 3), "box");
  const Foot above = box.footOf({1.2, 0.9, 2.5});
  EXPECT_LT((above.place - Vector3(1.2, 0.9, 2)).norm(), 1e-15);
  EXPECT_NEAR(above.distance, 0.5, 1e-15);
  EXPECT_NEAR(box.footOf({1.2, 0.9, 1.75}).distance, -0.25, 1e-15);
  // Beyond an edge and a corner.
  EXPECT_NEAR(box.footOf({3, 0.9, 3}).distance, std::sqrt(2), 1e-15);
  EXPECT_EQ(box.footOf({3, 3, 3}).place, Vector3(2, 2, 2));
  EXPECT_GT(box.footOf({3, 3, 3}).distance, 0);
}

TEST(GuideSurface, HasNormalsThatDoNotGoOverCreases)
{
  const GuideSurface box(test::box({2, 2, 2}, 3), "box");
  EXPECT_EQ(box.footOf({1.9, 0.9, 2.5}).normal, Vector3::UnitZ());
  EXPECT_EQ(box.footOf({2.5, 0.9, 1.9}).normal, Vector3::UnitX());
}

TEST(GuideSurface, HasNormalsThatGoSmoothlyFromTriangleToTriangle)
{
  const GuideSurface sphere(test::icosphere(3), "sphere");
  test::Random random(3);
  for (int k = 0; k < 50; ++k) {
    const Foot foot = sphere.footOf(test::randomVector(random, 2));
    EXPECT_LT((foot.normal - foot.place.normalized()).norm(), 0.02);
    EXPECT_NEAR(foot.normal.norm(), 1, 1e-14);
  }
}

TEST(GuideSurface, KnowsItsBorderWhereverVerticesAreShared)
{
  for (const Mesh& mesh : {test::grid(4, 4), test::soup(test::grid(4, 4))}) {
    const GuideSurface square(mesh, "square");
    EXPECT_FALSE(square.footOf({2, 2, 1}).isOnBorder);
    EXPECT_FALSE(square.footOf({2.5, 2.5, 1}).isOnBorder);
    EXPECT_TRUE(square.footOf({2.3, -1, 1}).isOnBorder);
    EXPECT_TRUE(square.footOf({-1, -1, 0}).isOnBorder);
  }
}

TEST(GuideSurface, LeavesOutWhatIsNotThere)
{
  Mesh mesh = test::withVertex(test::grid(2, 2), Vector3::Constant(std::numeric_limits<double>::quiet_NaN()));
  mesh = test::withFace(std::move(mesh), {0, 1, 9});
  mesh = test::withFace(std::move(mesh), {0, 1, 2});  // on one line
  const GuideSurface square(mesh, "square");
  EXPECT_EQ(square.triangles().size(), 8U);
  EXPECT_EQ(square.footOf({0.5, 0.5, 3}).place, Vector3(0.5, 0.5, 0));
}

TEST(GuideSurface, NeedsAFaceWithAnArea)
{
  for (const Mesh& mesh : {Mesh{}, test::triangle({0, 0, 0}, {1, 0, 0}, {2, 0, 0})}) try {
      const GuideSurface surface(mesh, "scan.ply");
      ADD_FAILURE() << "a surface without an area";
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("scan.ply"));
      EXPECT_THAT(error.what(), HasSubstr("no faces with an area"));
    }
}

}  // namespace
}  // namespace holdfast
