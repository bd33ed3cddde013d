#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/mesh/vertex_triangles.h>

namespace holdfast {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(VertexTriangles, AscendAndAppearOnce)
{
  const VertexTriangles triangles({{0, 1, 2}, {2, 1, 4}, {4, 4, 1}, {1, 1, 1}}, 6);
  EXPECT_THAT(triangles.of(0), ElementsAre(0));
  EXPECT_THAT(triangles.of(1), ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(triangles.of(2), ElementsAre(0, 1));
  EXPECT_THAT(triangles.of(3), IsEmpty());
  EXPECT_THAT(triangles.of(4), ElementsAre(1, 2));
  EXPECT_THAT(triangles.of(5), IsEmpty());
}

}  // namespace
}  // namespace holdfast
