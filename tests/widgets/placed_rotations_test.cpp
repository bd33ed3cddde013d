#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/deform/deform_details.h>
#include <holdfast/geometry/rotation_log.h>
#include <holdfast/widgets/rotation_sphere/rotation_projection.h>

#include "support/meshes.h"

namespace holdfast {
namespace {

using ::testing::ElementsAre;

DeformResult rotatedBy(const Model& model, const Vector3& q)
{
  DeformResult deformation;
  deformation.details = std::make_shared<const DeformDetails>();
  deformation.rotations = q.transpose().replicate(model.solverMesh.unknownCount(), 1);
  return deformation;
}

TEST(SphereVertices, AreThoseOfFacesOnce)
{
  // Two triangles beside one another with corners of their own where they meet, and a vertex that no face uses.
  Mesh mesh;
  mesh.positions.resize(7, 3);
  mesh.positions << 0, 0, 0, 1, 0, 0, 0, 1, 0, 5, 5, 5, 1, 0, 0, 1, 1, 0, 0, 1, 0;
  mesh.faces.add({0, 1, 2});
  mesh.faces.add({4, 5, 6});
  const SphereVertices vertices = sphereVertices(makeModel(mesh, "two"));
  EXPECT_THAT(vertices.vertexOf, ElementsAre(0, 1, 2, 5));
  EXPECT_THAT(vertices.pointOf, ElementsAre(0, 1, 2, -1, 1, 3, 2));
}

TEST(PlacedRotations, GoOnFromWhatWasShownBefore)
{
  const Model model = makeModel(test::grid(3, 3), "grid");
  const auto first = placeRotations(model, rotatedBy(model, {0.3, 0.4, 0}), nullptr);
  const auto second = placeRotations(model, rotatedBy(model, {0, 0.4, 0}), first);
  EXPECT_EQ(second->vertices, first->vertices);
  EXPECT_EQ(second->frame.axes, first->frame.axes);
  const Eigen::Quaterniond rotation = rotationExp({0, 0.4, 0});
  ASSERT_EQ(second->places.size(), 16u);
  for (const Vector3& place : second->places)
    EXPECT_NEAR((place - Vector3(rotation.x(), rotation.y(), rotation.w())).norm(), 0, 1e-14);
}

TEST(PlacedRotations, AreDrawnUpToTheLimit)
{
  const Model few = makeModel(test::grid(3, 3), "grid");
  EXPECT_EQ(placeRotations(few, rotatedBy(few, {0.3, 0.4, 0}), nullptr)->drawn.size(), 16u);
  const Model many = makeModel(test::grid(150, 150), "grid");
  DeformResult spread = rotatedBy(many, Vector3::Zero());
  for (Index u = 0; u < many.solverMesh.unknownCount(); ++u)
    spread.rotations.row(u) = 0.01 * many.mesh.positions.row(many.solverMesh.weld.firstVertexOf[u]);
  const auto placed = placeRotations(many, spread, nullptr);
  EXPECT_EQ(placed->places.size(), 151u * 151u);
  EXPECT_LE(placed->drawn.size(), static_cast<std::size_t>(kMostSpherePoints));
  EXPECT_FALSE(placed->drawn.empty());
}

}  // namespace
}  // namespace holdfast
