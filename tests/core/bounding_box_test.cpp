#include <gtest/gtest.h>

#include <holdfast/geometry/bounding_box.h>

#include "support/meshes.h"

namespace holdfast {
namespace {

TEST(BoundingBox, HoldsEveryVertexAndNoMore)
{
  const Mesh mesh = test::box(Vector3(1, 2, 2), 3);
  EXPECT_EQ(boundingBox(mesh.positions).min(), Vector3(0, 0, 0));
  EXPECT_EQ(boundingBox(mesh.positions).max(), Vector3(1, 2, 2));
  EXPECT_DOUBLE_EQ(boundingBoxDiagonal(mesh.positions), 3);
}

TEST(BoundingBox, OfNothingIsEmpty)
{
  EXPECT_TRUE(boundingBox(Positions(0, 3)).isEmpty());
  EXPECT_EQ(boundingBoxDiagonal(Positions(0, 3)), 0);
}

}  // namespace
}  // namespace holdfast
