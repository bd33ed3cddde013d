#include <map>

#include <gtest/gtest.h>

#include <holdfast/widgets/mesh/coarse_surface.h>

#include "support/law_meshes.h"
#include "support/meshes.h"

namespace holdfast {
namespace {

/// How often the triangles run through each edge from one place to another, less how often they run back.
std::map<std::pair<Index, Index>, int> balance(const Polygons& triangles, const std::vector<Index>& vertexOf)
{
  std::map<std::pair<Index, Index>, int> times;
  for (Index t = 0; t < triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const Index a = vertexOf[triangles[t][k]];
      const Index b = vertexOf[triangles[t][(k + 1) % 3]];
      times[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
    }
  return times;
}

bool isClosed(const Polygons& triangles, const std::vector<Index>& vertexOf)
{
  const auto times = balance(triangles, vertexOf);
  return std::all_of(times.begin(), times.end(), [](const auto& edge) { return edge.second == 0; });
}

double volume(const Polygons& triangles, const ShadedSurface& surface, const Positions& positions)
{
  double sum = 0;
  for (Index t = 0; t < triangles.size(); ++t) {
    const auto corner = [&](int k) { return Vector3(positions.row(surface.vertexOf[triangles[t][k]])); };
    sum += corner(0).dot(corner(1).cross(corner(2))) / 6;
  }
  return sum;
}

TEST(CoarseTriangles, AreAboutAsManyAsAskedFor)
{
  const Model model = makeModel(test::icosphere(6), "sphere");
  const ShadedSurface surface = cutAtSharpEdges(model);
  for (const Index target : {800, 3000, 12000})
    EXPECT_NEAR(
        static_cast<double>(coarseTriangles(model, surface, target).triangles.size()) / static_cast<double>(target), 1,
        0.4)
        << target;
}

TEST(CoarseTriangles, OfASmallMeshAreItsOwn)
{
  const Model model = makeModel(test::box({1, 2, 3}, 4), "box");
  const ShadedSurface surface = cutAtSharpEdges(model);
  EXPECT_EQ(coarseTriangles(model, surface, kCoarseTriangles).triangles, surface.triangles);
}

TEST(CoarseTriangles, OfASphereCloseIt)
{
  const Model model = makeModel(test::icosphere(5), "sphere");
  const ShadedSurface surface = cutAtSharpEdges(model);
  const Polygons coarse = coarseTriangles(model, surface, 2000).triangles;
  EXPECT_TRUE(isClosed(coarse, surface.vertexOf));
  EXPECT_NEAR(volume(coarse, surface, model.mesh.positions), volume(surface.triangles, surface, model.mesh.positions),
              0.08);
}

TEST(CoarseTriangles, OfSharpEdgesHaveNoGaps)
{
  const Model model = makeModel(test::box({1, 2, 3}, 30), "box");
  const ShadedSurface surface = cutAtSharpEdges(model);
  const Polygons coarse = coarseTriangles(model, surface, 1500).triangles;
  EXPECT_LT(coarse.size(), surface.triangles.size() / 2);
  EXPECT_TRUE(isClosed(coarse, surface.vertexOf));
}

TEST(CoarseTriangles, OfAFileWithoutSharedVerticesHaveNoGaps)
{
  const Model model = makeModel(test::soup(test::icosphere(5)), "soup");
  const ShadedSurface surface = cutAtSharpEdges(model);
  EXPECT_TRUE(isClosed(coarseTriangles(model, surface, 2000).triangles, surface.vertexOf));
}

TEST(CoarseTriangles, KeepBothSidesOfAThinWallApart)
{
  const Model model = makeModel(test::box({4, 4, 0.01}, 40), "plate");
  const ShadedSurface surface = cutAtSharpEdges(model);
  const Polygons coarse = coarseTriangles(model, surface, 1000).triangles;
  EXPECT_NEAR(volume(coarse, surface, model.mesh.positions), 0.16, 0.02);
}

TEST(CoarseSurface, LeavesOutWhatStandsForHiddenTriangles)
{
  const Model model = makeModel(test::icosphere(7), "sphere");
  const ShadedSurface surface = cutAtSharpEdges(model);
  CoarseSurface coarse(model, surface);
  const Index all = coarse.triangles().size();
  ASSERT_LT(2 * all, surface.triangles.size());
  std::vector<char> isHidden;
  for (const Triangle& triangle : model.triangulation.triangles)
    isHidden.push_back(model.mesh.positions(triangle, 2).maxCoeff() < 0 ? 1 : 0);
  EXPECT_TRUE(coarse.isSolid());
  coarse.setHidden(isHidden);
  EXPECT_FALSE(coarse.isSolid()) << "backs are seen";
  EXPECT_NEAR(static_cast<double>(coarse.triangles().size()) / static_cast<double>(all), 0.5, 0.05);
  for (Index t = 0; t < coarse.triangles().size(); ++t)
    for (const Index point : coarse.triangles()[t]) EXPECT_GT(model.mesh.positions(coarse.vertexOf()[point], 2), -0.1);
  EXPECT_EQ(coarse.data().GetNumberOfPolys(), coarse.triangles().size());
  coarse.setHidden({});
  EXPECT_EQ(coarse.triangles().size(), all);
  EXPECT_TRUE(coarse.isSolid());
}

}  // namespace
}  // namespace holdfast
