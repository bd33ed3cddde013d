#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include <holdfast/mesh/edges.h>

#include "support/law_meshes.h"
#include "support/meshes.h"

namespace holdfast {
namespace {

TEST(Edges, EachIsSeenOnceWithAllItsTriangles)
{
  for (const test::NamedMesh& named : test::lawMeshes()) {
    SCOPED_TRACE(named.name);
    const std::vector<Triangle> triangles = triangulate(named.mesh).triangles;
    std::map<std::pair<Index, Index>, std::set<Index>> expected;
    for (std::size_t t = 0; t < triangles.size(); ++t)
      for (int k = 0; k < 3; ++k)
        expected[std::minmax(triangles[t][k], triangles[t][(k + 1) % 3])].insert(static_cast<Index>(t));
    std::map<std::pair<Index, Index>, std::set<Index>> found;
    forEachEdge(sortedHalfEdges(triangles), [&](std::span<const HalfEdge> edge) {
      auto [entry, isNew] = found.try_emplace({edge[0].a, edge[0].b});
      EXPECT_TRUE(isNew);
      for (const HalfEdge& half : edge) entry->second.insert(half.triangle);
    });
    EXPECT_EQ(found, expected);
  }
}

TEST(Edges, NameTheSideAndTheDirectionOfEachTriangle)
{
  for (const HalfEdge& half : sortedHalfEdges({{4, 2, 7}})) {
    const Triangle triangle{4, 2, 7};
    const Index from = triangle[half.side];
    const Index to = triangle[(half.side + 1) % 3];
    EXPECT_EQ(half.a, std::min(from, to));
    EXPECT_EQ(half.b, std::max(from, to));
    EXPECT_EQ(half.isForward, from < to);
  }
}

TEST(Edges, ObeyEulersFormulaOnAClosedSurface)
{
  const Mesh mesh = test::icosphere(2);
  Index edges = 0;
  forEachEdge(sortedHalfEdges(triangulate(mesh).triangles), [&](std::span<const HalfEdge> edge) {
    EXPECT_EQ(edge.size(), 2U);
    EXPECT_NE(edge[0].isForward, edge[1].isForward);
    ++edges;
  });
  EXPECT_EQ(mesh.vertexCount() - edges + mesh.faces.size(), 2);
}

TEST(Edges, LeaveOutSidesThatJoinAVertexToItself)
{
  const std::vector<HalfEdge> halfEdges = sortedHalfEdges({{1, 1, 2}});
  ASSERT_EQ(halfEdges.size(), 2U);
  for (const HalfEdge& half : halfEdges) EXPECT_NE(half.a, half.b);
  EXPECT_TRUE(sortedHalfEdges({{3, 3, 3}}).empty());
}

}  // namespace
}  // namespace holdfast
