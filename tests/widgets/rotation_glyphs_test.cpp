
#include <gtest/gtest.h>

#include <holdfast/geometry/rotation_log.h>
#include <holdfast/widgets/marks/rotation_glyphs.h>

#include "support/law_meshes.h"
#include "support/meshes.h"

namespace holdfast {
namespace {

Columns3 everywhere(const Model& model, const Vector3& q)
{
  return q.transpose().replicate(model.solverMesh.unknownCount(), 1);
}

TEST(RotationArrows, LieAlongTheAxisByTheRightHandRule)
{
  const Model model = makeModel(test::grid(3, 3), "grid");
  const Positions moved = 2 * model.mesh.positions;
  const auto arrows = rotationArrows(model, {5, 9}, moved, everywhere(model, rotationLog(Vector3(0, 0, -2), 45)), 8);
  ASSERT_EQ(arrows.size(), 2);
  EXPECT_EQ(arrows[1].vertex, 9);
  EXPECT_EQ(arrows[1].tail, Vector3(moved.row(9)));
  EXPECT_NEAR((arrows[1].along - Vector3(0, 0, -4)).norm(), 0, 1e-12);
}

TEST(RotationArrows, OfMoreThanAQuarterTurnAreNotLonger)
{
  const Model model = makeModel(test::grid(3, 3), "grid");
  Columns3 q = everywhere(model, rotationLog(Vector3::UnitX(), 720));
  q.row(1) = rotationLog(Vector3::UnitX(), 180).transpose();
  const auto arrows = rotationArrows(model, {0, 1}, model.mesh.positions, q, 8);
  ASSERT_EQ(arrows.size(), 2);
  EXPECT_NEAR(arrows[0].along.norm(), 8, 1e-12);
  EXPECT_NEAR(arrows[1].along.norm(), 2, 1e-12);
}

TEST(RotationArrows, AreNotWhereNothingTurns)
{
  const Model model = makeModel(test::grid(3, 3), "grid");
  Columns3 q = everywhere(model, Vector3::Zero());
  q.row(7) = rotationLog(Vector3::UnitY(), 30).transpose();
  q.row(8) = rotationLog(Vector3::UnitY(), 1e-6).transpose();
  const auto arrows = rotationArrows(model, {6, 7, 8}, model.mesh.positions, q, 8);
  ASSERT_EQ(arrows.size(), 1);
  EXPECT_EQ(arrows[0].vertex, 7);
}

TEST(RotationArrows, OfWeldedVerticesAreThoseOfTheirUnknown)
{
  const Model model = makeModel(test::soup(test::icosphere(1)), "soup");
  Columns3 q = everywhere(model, Vector3::Zero());
  const Index last = model.mesh.vertexCount() - 1;
  q.row(model.solverMesh.weld.unknownOf[last]) = rotationLog(Vector3::UnitY(), 90).transpose();
  const auto arrows = rotationArrows(model, {last}, model.mesh.positions, q, 8);
  ASSERT_EQ(arrows.size(), 1);
  EXPECT_NEAR((arrows[0].along - Vector3(0, 8, 0)).norm(), 0, 1e-12);
}

}  // namespace
}  // namespace holdfast
