#include <set>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/document/point_lists.h>
#include <holdfast/surface/surface_locator.h>

#include "support/law_meshes.h"
#include "support/meshes.h"
#include "support/point_constraints.h"
#include "support/random.h"

namespace holdfast {
namespace {

ConstraintList nearPoints(const std::vector<Vector3>& places)
{
  std::vector<Constraint> constraints;
  for (const Vector3& place : places) constraints.push_back(test::moveTo(AtNear{place}, place));
  return test::listOf(constraints);
}

TEST(PointListImport, TellsHowFarEachPointIsFromTheSurface)
{
  const Model model = makeModel(test::grid(4, 4), "mesh");
  const ImportPreview preview =
      previewImport(nearPoints({{1, 1, 0}, {0.25, 0.5, 3}, {-3, 2, 4}, {2.5, 2, -1}}), {}, model);
  ASSERT_EQ(preview.points.size(), 4U);
  EXPECT_EQ(preview.points[1].place, Vector3(0.25, 0.5, 3));
  EXPECT_EQ(preview.points[0].distance, 0);
  EXPECT_EQ(preview.points[1].distance, 3);
  EXPECT_EQ(preview.points[2].distance, 5);
  EXPECT_EQ(preview.points[3].distance, 1);
  EXPECT_EQ(preview.maxDistance, 5);
  EXPECT_EQ(preview.meanDistance, 2.25);
  EXPECT_EQ(preview.others, 0);
}

TEST(PointListImport, NamesTheClosestPointInTheTermsOfTheFile)
{
  const Model model = makeModel(test::polygonPlate(3, 3), "mesh");
  SurfaceLocator locator(model.mesh, model.triangulation);
  test::Random random(5);
  std::vector<Vector3> places;
  for (int k = 0; k < 300; ++k) places.push_back(test::randomVector(random, 8));
  for (Index v = 0; v < model.mesh.vertexCount(); ++v) places.emplace_back(model.mesh.positions.row(v));
  const ImportPreview preview = previewImport(nearPoints(places), {}, model);
  ASSERT_EQ(preview.points.size(), places.size());
  std::set<std::size_t> kinds;
  for (const ImportedPoint& point : preview.points) {
    kinds.insert(point.at.index());
    const Vector3 named = positionOf(locator.locate(point.at, {"list", 0, ""}), model.mesh.positions);
    EXPECT_NEAR((named - point.place).norm(), point.distance, 1e-13);
  }
  EXPECT_EQ(kinds, (std::set<std::size_t>{0, 1, 2})) << "vertices, edges and faces";
}

TEST(PointListImport, TellsNamesThatAreTakenAndWhatIsNoPoint)
{
  const Model model = makeModel(test::grid(4, 4), "mesh");
  ConstraintList imported = nearPoints({{1, 1, 0}, {2, 2, 0}});
  imported.constraints.insert(imported.constraints.begin(), test::hold({0}));
  imported.constraints[0].name = "base";
  ConstraintList present = test::listOf({test::hold({1}), test::hold({2})});
  present.constraints[0].name = "base";
  present.constraints[1].name = imported.constraints[2].name;
  const ImportPreview preview = previewImport(imported, present, model);
  ASSERT_EQ(preview.points.size(), 2U);
  EXPECT_EQ(preview.others, 1);
  EXPECT_EQ(preview.takenNames, 2);
  EXPECT_EQ(preview.points[1].index, 2);
}

TEST(PointListImport, OfNothingIsEmpty)
{
  const ImportPreview preview = previewImport({}, {}, makeModel(test::grid(4, 4), "mesh"));
  EXPECT_TRUE(preview.points.empty());
  EXPECT_EQ(preview.maxDistance, 0);
}

}  // namespace
}  // namespace holdfast
