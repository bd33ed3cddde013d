#include <gtest/gtest.h>

#include <holdfast/mesh/mesh.h>

namespace holdfast {
namespace {

TEST(Polygons, HaveTheCornersOfEachFace)
{
  Polygons faces;
  EXPECT_TRUE(faces.isEmpty());
  faces.add({0, 1, 2});
  faces.add(std::vector<Index>{2, 1, 5, 4});
  ASSERT_EQ(faces.size(), 2);
  EXPECT_EQ(faces.cornerCount(), 7);
  EXPECT_EQ(faces[1].size(), 4);
  EXPECT_EQ(faces[1][2], 5);
}

TEST(Polygons, RefuseIdsOfMoreThan32Bits)
{
  Polygons faces;
  EXPECT_THROW(faces.add({0, 1, Index{1} << 31}), std::length_error);
  Triangles triangles(1, 3);
  triangles << 0, 1, -(Index{1} << 40);
  EXPECT_THROW(static_cast<void>(Polygons(triangles)), std::length_error);
}

}  // namespace
}  // namespace holdfast
