#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/surface/edge_graph.h>

#include "support/meshes.h"
#include "support/random.h"

namespace holdfast {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

EdgeGraph graphOf(const Mesh& mesh)
{
  return EdgeGraph(makeSolverMesh(mesh, triangulate(mesh)));
}

bool contains(const std::vector<Index>& sorted, Index vertex)
{
  return std::binary_search(sorted.begin(), sorted.end(), vertex);
}

bool joinsAny(const EdgeGraph& graph, Index vertex, const std::vector<Index>& others)
{
  const auto neighbours = graph.neighbours(vertex);
  return std::any_of(neighbours.begin(), neighbours.end(), [&](Index other) { return contains(others, other); });
}

/// Curve, inside and outside hold each vertex once, and no edge leads from the inside to the outside.
void expectDivision(const CurveRegion& region, const EdgeGraph& graph)
{
  std::vector<Index> all = region.curve;
  all.insert(all.end(), region.inside.begin(), region.inside.end());
  all.insert(all.end(), region.outside.begin(), region.outside.end());
  std::sort(all.begin(), all.end());
  ASSERT_EQ(static_cast<Index>(all.size()), graph.vertexCount());
  for (Index v = 0; v < graph.vertexCount(); ++v) EXPECT_EQ(all[v], v);
  for (const Index v : region.inside) EXPECT_FALSE(joinsAny(graph, v, region.outside)) << v;
  EXPECT_TRUE(std::is_sorted(region.curve.begin(), region.curve.end()));
  EXPECT_TRUE(std::is_sorted(region.inside.begin(), region.inside.end()));
  EXPECT_TRUE(std::is_sorted(region.outside.begin(), region.outside.end()));
}

TEST(ClosedCurve, PassesThePlacesInOrderAlongEdges)
{
  const EdgeGraph graph = graphOf(test::icosphere(2));
  test::Random random(4);
  for (int k = 0; k < 30; ++k) {
    std::vector<Index> places;
    while (places.size() < 5)
      if (const Index v = random.integer(0, 161); std::count(places.begin(), places.end(), v) == 0) places.push_back(v);
    const std::vector<Index> curve = closedCurve(graph, places);
    auto at = curve.begin();
    for (const Index place : places) {
      at = std::find(at, curve.end(), place);
      ASSERT_NE(at, curve.end());
    }
    for (std::size_t i = 0; i < curve.size(); ++i)
      EXPECT_THAT(graph.neighbours(curve[i]), testing::Contains(curve[(i + 1) % curve.size()]));
  }
}

TEST(CurveRegion, IsBoundedByItsCurveAndPartitionsTheSurface)
{
  const EdgeGraph graph = graphOf(test::icosphere(3));
  test::Random random(5);
  int divided = 0;
  for (int k = 0; k < 40; ++k) {
    const std::vector<Index> places{random.integer(0, 600), random.integer(0, 600), random.integer(0, 600)};
    const CurveRegion region = regionOfCurve(graph, closedCurve(graph, places));
    expectDivision(region, graph);
    divided += region.inside.empty() ? 0 : 1;
  }
  EXPECT_GT(divided, 30) << "curves on a sphere divide it unless they are very tight";
}

/// Around the squares [x, x + size] x [y, y + size] of a grid of `columns`, counter-clockwise from the lower left.
std::vector<Index> squareOf(Index columns, Index x, Index y, Index size)
{
  std::vector<Index> curve;
  const auto id = [&](Index i, Index j) { return j * (columns + 1) + i; };
  for (Index k = 0; k < size; ++k) curve.push_back(id(x + k, y));
  for (Index k = 0; k < size; ++k) curve.push_back(id(x + size, y + k));
  for (Index k = 0; k < size; ++k) curve.push_back(id(x + size - k, y + size));
  for (Index k = 0; k < size; ++k) curve.push_back(id(x, y + size - k));
  return curve;
}

TEST(CurveRegion, OfACurveThatCrossesItselfIsAllButTheLargestPiece)
{
  const EdgeGraph graph = graphOf(test::grid(9, 9));
  std::vector<Index> eight = squareOf(9, 1, 1, 3);
  const std::vector<Index> second = squareOf(9, 4, 4, 2);
  eight.insert(eight.end(), second.begin(), second.end());
  const CurveRegion region = regionOfCurve(graph, eight);
  expectDivision(region, graph);
  EXPECT_THAT(region.inside, ElementsAre(22, 23, 32, 33, 55));
  EXPECT_EQ(region.curve.size(), 12U + 8U - 1U);
}

TEST(CurveRegion, OfTwoEqualSidesTheOneWithTheLowestIdIsInside)
{
  // The line x = 2, there and back.
  const EdgeGraph graph = graphOf(test::grid(4, 2));
  const CurveRegion region = regionOfCurve(graph, {2, 7, 12, 7});
  EXPECT_THAT(region.curve, ElementsAre(2, 7, 12));
  EXPECT_THAT(region.inside, ElementsAre(0, 1, 5, 6, 10, 11));
  EXPECT_THAT(region.outside, ElementsAre(3, 4, 8, 9, 13, 14));
}

TEST(CurveRegion, HasNoInsideWhereTheCurveLeavesOnePiece)
{
  const EdgeGraph graph = graphOf(test::grid(4, 4));
  EXPECT_THAT(regionOfCurve(graph, squareOf(4, 0, 0, 4)).inside, IsEmpty()) << "the border";
  EXPECT_THAT(regionOfCurve(graph, {0, 1, 6}).inside, IsEmpty()) << "a triangle";
}

}  // namespace
}  // namespace holdfast
