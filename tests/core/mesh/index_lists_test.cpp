#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/mesh/index_lists.h>

namespace holdfast {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(IndexLists, TrianglesOfVerticesAscendAndAppearOnce)
{
  const IndexLists triangles = trianglesOfVertices({{0, 1, 2}, {2, 1, 4}, {4, 4, 1}, {1, 1, 1}}, 6);
  EXPECT_THAT(triangles[0], ElementsAre(0));
  EXPECT_THAT(triangles[1], ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(triangles[2], ElementsAre(0, 1));
  EXPECT_THAT(triangles[3], IsEmpty());
  EXPECT_THAT(triangles[4], ElementsAre(1, 2));
  EXPECT_THAT(triangles[5], IsEmpty());
}

}  // namespace
}  // namespace holdfast
