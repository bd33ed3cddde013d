#include <algorithm>
#include <numeric>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/deform/model.h>
#include <holdfast/surface/vertex_regions.h>

#include "support/law_meshes.h"
#include "support/meshes.h"
#include "support/random.h"

namespace holdfast {
namespace {

using testing::ElementsAre;
using testing::ElementsAreArray;
using testing::IsEmpty;

/// A mesh and what grows on it.
struct GrowingRegions {
  explicit GrowingRegions(Mesh mesh) : model(makeModel(std::move(mesh), "mesh")) {}

  Model model;
  VertexRegions regions{model.mesh, model.solverMesh};
};

TEST(RegionSize, CountsTrianglesWithAllCornersAndTheirArea)
{
  const Model model = makeModel(test::grid(3, 2), "grid");
  const std::vector<Index> square{0, 1, 4, 5};
  const RegionSize one = sizeOfRegion(square, model.triangulation.triangles, model.mesh.positions);
  EXPECT_EQ(one.triangles, 2);
  EXPECT_DOUBLE_EQ(one.area, 1);
  EXPECT_EQ(Vector3(one.box.sizes()), Vector3(1, 1, 0));
  EXPECT_EQ(sizeOfRegion(std::vector<Index>{0, 1}, model.triangulation.triangles, model.mesh.positions).triangles, 0);
  std::vector<Index> all(12);
  std::iota(all.begin(), all.end(), Index{0});
  const Positions twice = 2 * model.mesh.positions;
  EXPECT_DOUBLE_EQ(sizeOfRegion(all, model.triangulation.triangles, twice).area, 24);
}

std::vector<Index> randomSet(test::Random& random, Index count)
{
  std::vector<Index> set;
  for (Index v = 0; v < count; ++v)
    if (random.integer(0, 2) == 0) set.push_back(v);
  return set;
}

/// `set` and all vertices that share a side of a triangle with one of it.
std::set<Index> plainlyGrown(const Model& model, const std::vector<Index>& set)
{
  std::set<Index> grown(set.begin(), set.end());
  for (const Triangle& triangle : model.triangulation.triangles)
    if (std::any_of(triangle.begin(), triangle.end(),
                    [&](Index v) { return std::binary_search(set.begin(), set.end(), v); }))
      grown.insert(triangle.begin(), triangle.end());
  return grown;
}

TEST(VertexRegions, GrowByTheVerticesOfTheTrianglesAround)
{
  test::Random random(21);
  for (const test::NamedMesh& named : test::lawMeshes()) {
    SCOPED_TRACE(named.name);
    const GrowingRegions grown(named.mesh);
    const std::vector<Index> set{random.integer(0, named.mesh.vertexCount() - 1)};
    EXPECT_THAT(grown.regions.grown(set), ElementsAreArray(plainlyGrown(grown.model, set)));
  }
}

TEST(VertexRegions, ShrinkByWhatTheRestWouldGrow)
{
  test::Random random(22);
  for (const test::NamedMesh& named : test::lawMeshes()) {
    SCOPED_TRACE(named.name);
    const GrowingRegions grown(named.mesh);
    const std::vector<Index> set = randomSet(random, named.mesh.vertexCount());
    const VertexRegions& regions = grown.regions;
    EXPECT_EQ(regions.shrunk(set), regions.inverted(regions.grown(regions.inverted(set))));
    EXPECT_EQ(regions.inverted(regions.inverted(set)), set);
  }
}

TEST(VertexRegions, ShrinkingKeepsBordersOfTheMesh)
{
  const GrowingRegions grown(test::grid(3, 2));
  EXPECT_EQ(grown.regions.shrunk(grown.regions.inverted({})).size(), 12U) << "all of an open mesh stays all";
  EXPECT_THAT(grown.regions.shrunk(std::vector<Index>{0, 1, 4, 5, 8, 9}), ElementsAre(0, 4, 8));
}

TEST(VertexRegions, ConnectedPartsAreWhole)
{
  const Mesh mesh = test::withVertex(test::merged(test::tetrahedron(), test::grid(1, 1)), {9, 9, 9});
  const GrowingRegions grown(mesh);
  EXPECT_THAT(grown.regions.connected(std::vector<Index>{2}), ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(grown.regions.connected(std::vector<Index>{7}), ElementsAre(4, 5, 6, 7));
  EXPECT_THAT(grown.regions.connected(std::vector<Index>{8}), ElementsAre(8)) << "no face uses it";
  EXPECT_THAT(grown.regions.connected(std::vector<Index>{1, 8}), ElementsAre(0, 1, 2, 3, 8));
}

TEST(VertexRegions, InvertingLeavesOutVerticesThatNoFaceUses)
{
  const GrowingRegions grown(test::withVertex(test::tetrahedron(), {9, 9, 9}));
  EXPECT_THAT(grown.regions.inverted({}), ElementsAre(0, 1, 2, 3));
}

TEST(VertexRegions, VerticesOfOneUnknownGoTogether)
{
  const Mesh whole = test::quadBox({1, 2, 3}, 3);
  const Mesh parts = test::soup(whole);
  const std::vector<Index> vertexOf = [&] {
    std::vector<Index> vertices;
    for (Index f = 0; f < whole.faces.size(); ++f)
      vertices.insert(vertices.end(), whole.faces[f].begin(), whole.faces[f].end());
    return vertices;
  }();
  const auto inParts = [&](const std::vector<Index>& set) {
    std::vector<Index> result;
    for (std::size_t v = 0; v < vertexOf.size(); ++v)
      if (std::binary_search(set.begin(), set.end(), vertexOf[v])) result.push_back(static_cast<Index>(v));
    return result;
  };
  GrowingRegions a(whole);
  GrowingRegions b(parts);
  const std::vector<Index> one{5};
  const std::vector<Index> oneOfSeveral{
      static_cast<Index>(std::find(vertexOf.begin(), vertexOf.end(), 5) - vertexOf.begin())};
  EXPECT_EQ(b.regions.grown(oneOfSeveral), inParts(a.regions.grown(one)));
  EXPECT_EQ(b.regions.inverted(oneOfSeveral), inParts(a.regions.inverted(one)));
  EXPECT_EQ(b.regions.smooth(7, 1), inParts(a.regions.smooth(7, 1)));
  EXPECT_EQ(b.regions.connected(std::vector<Index>{0}).size(), vertexOf.size());
  const Vector3 place = whole.positions.row(whole.faces[7][0]);
  EXPECT_EQ(b.regions.within(0.8, place, 7, parts.positions),
            inParts(a.regions.within(0.8, place, 7, whole.positions)));
}

TEST(VertexRegions, SmoothRegionsHoldTheVerticesOfTheirFaces)
{
  const GrowingRegions grown(test::box({1, 1, 1}, 3));
  const std::vector<Index> side = grown.regions.smooth(0, 30);
  EXPECT_EQ(side.size(), 16U);
  int flat = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double first = grown.model.mesh.positions(side.front(), axis);
    flat +=
        std::all_of(side.begin(), side.end(), [&](Index v) { return grown.model.mesh.positions(v, axis) == first; });
  }
  EXPECT_EQ(flat, 1);
}

/// The dab, by growing a set ring by ring until nothing comes in.
std::vector<Index> plainDab(const GrowingRegions& grown, double radius, const Vector3& place, Index face,
                            const Positions& positions)
{
  const auto isInside = [&](Index v) { return (positions.row(v).transpose() - place).norm() <= radius; };
  std::set<Index> dab;
  for (const Index v : grown.model.mesh.faces[face])
    if (isInside(v)) dab.insert(v);
  for (std::size_t before = dab.size() + 1; before != dab.size();) {
    before = dab.size();
    for (const Index v : plainlyGrown(grown.model, {dab.begin(), dab.end()}))
      if (isInside(v)) dab.insert(v);
  }
  return {dab.begin(), dab.end()};
}

TEST(VertexRegions, DabsAreWhatEdgesReachWithinTheBall)
{
  test::Random random(23);
  std::size_t total = 0;
  for (const test::NamedMesh& named : test::lawMeshes()) {
    SCOPED_TRACE(named.name);
    GrowingRegions grown(named.mesh);
    const Positions positions = 1.5 * named.mesh.positions;
    for (int k = 0; k < 30; ++k) {
      const Index face = random.integer(0, named.mesh.faces.size() - 1);
      const Vector3 place = positions.row(named.mesh.faces[face][0]);
      const double radius = random.uniform(0, 3);
      const std::vector<Index> dab = grown.regions.within(radius, place, face, positions);
      EXPECT_EQ(dab, plainDab(grown, radius, place, face, positions));
      total += dab.size();
    }
  }
  EXPECT_GT(total, 1000U);
}

TEST(VertexRegions, DabsStayOnTheirSideOfAThinWall)
{
  constexpr Index kDivisions = 10;
  GrowingRegions grown(test::box({10, 10, 0.1}, kDivisions));
  const Positions& positions = grown.model.mesh.positions;
  const double top = positions.col(2).maxCoeff();
  Index face = 0;
  const auto isInTheMiddle = [&](Index f) {
    return std::all_of(grown.model.mesh.faces[f].begin(), grown.model.mesh.faces[f].end(), [&](Index v) {
      const Vector3 corner = positions.row(v);
      return corner[2] == top && std::abs(corner[0] - positions.col(0).mean()) < 1.5 &&
             std::abs(corner[1] - positions.col(1).mean()) < 1.5;
    });
  };
  while (!isInTheMiddle(face)) ++face;
  const Vector3 place = positions.row(grown.model.mesh.faces[face][0]);
  const std::vector<Index> dab = grown.regions.within(2.5, place, face, positions);
  EXPECT_GT(dab.size(), 12U);
  for (const Index v : dab) EXPECT_EQ(positions(v, 2), top) << v;
}

TEST(VertexRegions, DabsWithoutACornerInReachAreEmpty)
{
  GrowingRegions grown(test::grid(2, 2));
  EXPECT_THAT(grown.regions.within(0.1, {0.5, 0.25, 0}, 0, grown.model.mesh.positions), IsEmpty());
  EXPECT_THAT(grown.regions.within(0, {0, 0, 0}, 0, grown.model.mesh.positions), ElementsAre(0));
}

}  // namespace
}  // namespace holdfast
