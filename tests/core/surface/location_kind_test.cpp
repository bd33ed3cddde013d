#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/surface/surface_locator.h>
#include <holdfast/words/error.h>

#include "support/law_meshes.h"
#include "support/meshes.h"
#include "support/random.h"

namespace holdfast {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// One mesh, and the points of it that change their kind.
class PointOf {
 public:
  explicit PointOf(Mesh mesh) : mesh_(std::move(mesh)), triangulation_(triangulate(mesh_)) {}

  [[nodiscard]] SurfaceLocation as(LocationKind kind, const SurfaceLocation& location)
  {
    return converted(location, kind, mesh_, locator_);
  }
  [[nodiscard]] AtVertex asVertex(const SurfaceLocation& location)
  {
    return std::get<AtVertex>(as(LocationKind::Vertex, location));
  }
  [[nodiscard]] AtEdge asEdge(const SurfaceLocation& location)
  {
    return std::get<AtEdge>(as(LocationKind::Edge, location));
  }
  [[nodiscard]] AtFace asFace(const SurfaceLocation& location)
  {
    return std::get<AtFace>(as(LocationKind::Face, location));
  }
  [[nodiscard]] Vector3 placeOf(const SurfaceLocation& location)
  {
    return positionOf(locator_.locate(location, {}), mesh_.positions);
  }
  [[nodiscard]] std::string refusal(LocationKind kind, const SurfaceLocation& location)
  {
    try {
      (void)as(kind, location);
    } catch (const InputError& error) {
      return error.reason();
    }
    return {};
  }
  [[nodiscard]] const Mesh& mesh() const { return mesh_; }

 private:
  Mesh mesh_;
  Triangulation triangulation_;
  SurfaceLocator locator_{mesh_, triangulation_};
};

constexpr std::array kAllKinds{LocationKind::Vertex, LocationKind::Edge, LocationKind::Face, LocationKind::Near};

/// Somewhere in a face, with no weight zero.
AtFace insideOf(Index face, const Mesh& mesh, test::Random& random)
{
  AtFace at{face, {}};
  double sum = 0;
  for (std::size_t k = 0; k < mesh.faces[face].size(); ++k) sum += at.weights.emplace_back(random.uniform(0.1, 1));
  for (double& weight : at.weights) weight /= sum;
  return at;
}

double diagonalOf(const Mesh& mesh)
{
  return (mesh.positions.colwise().maxCoeff() - mesh.positions.colwise().minCoeff()).norm();
}

TEST(LocationKind, IsThatOfTheLocation)
{
  EXPECT_EQ(kindOf(AtVertex{3}), LocationKind::Vertex);
  EXPECT_EQ(kindOf(AtEdge{3, 4, 0.5}), LocationKind::Edge);
  EXPECT_EQ(kindOf(AtFace{3, {1, 0, 0}}), LocationKind::Face);
  EXPECT_EQ(kindOf(AtNear{}), LocationKind::Near);
}

TEST(LocationKind, OfAPointOnAVertexChangesNothingOfItsPlace)
{
  for (const test::NamedMesh& named : test::lawMeshes())
    for (const bool isSoup : {false, true}) {
      SCOPED_TRACE(named.name + (isSoup ? ", every face by itself" : ""));
      PointOf point(isSoup ? test::soup(named.mesh) : named.mesh);
      for (Index v = 0; v < point.mesh().vertexCount(); v += 7)
        for (const LocationKind kind : kAllKinds) {
          const SurfaceLocation there = point.as(kind, AtVertex{v});
          EXPECT_EQ(kindOf(there), kind);
          EXPECT_EQ(point.placeOf(there), point.placeOf(AtVertex{v})) << "bit for bit";
        }
      const AtEdge edge = point.asEdge(AtVertex{5});
      EXPECT_EQ(edge.i, 5);
      EXPECT_EQ(edge.t, 1);
      const AtFace face = point.asFace(AtVertex{5});
      const auto corner = std::max_element(face.weights.begin(), face.weights.end()) - face.weights.begin();
      EXPECT_EQ(point.mesh().faces[face.face][static_cast<std::size_t>(corner)], 5);
    }
}

TEST(LocationKind, OfAPointOnAnEdgeKeepsItsShareInAFaceAndTakesTheNearerEnd)
{
  for (const test::NamedMesh& named : test::lawMeshes()) {
    SCOPED_TRACE(named.name);
    PointOf point(test::soup(named.mesh));
    const auto corners = point.mesh().faces[point.mesh().faces.size() / 2];
    const AtEdge edge{corners.back(), corners.front(), 0.3};
    const AtFace face = point.asFace(edge);
    EXPECT_EQ(face.face, point.mesh().faces.size() / 2) << "in a soup no other face has the edge";
    EXPECT_EQ(face.weights.back(), 0.3);
    EXPECT_EQ(face.weights.front(), 0.7);
    EXPECT_EQ(point.asVertex(edge).vertex, corners.front());
    EXPECT_EQ(point.asVertex(AtEdge{edge.i, edge.j, 0.5}).vertex, corners.back()) << "the first, of two as near";
    EXPECT_EQ(std::get<AtNear>(point.as(LocationKind::Near, edge)).place, point.placeOf(edge));
    const AtEdge again = point.asEdge(face);
    EXPECT_LT((point.placeOf(again) - point.placeOf(edge)).norm(), 1e-15 * diagonalOf(point.mesh()));
  }
}

TEST(LocationKind, OfAPointInAFaceTakesItsNearestCornerAndItsNearestSide)
{
  test::Random random(5);
  for (const test::NamedMesh& named : test::lawMeshes()) {
    SCOPED_TRACE(named.name);
    PointOf point(named.mesh);
    for (Index f = 0; f < point.mesh().faces.size(); f += 5) {
      const AtFace at = insideOf(f, point.mesh(), random);
      const auto corners = point.mesh().faces[f];
      const Vector3 place = point.placeOf(at);
      const auto distanceTo = [&](const SurfaceLocation& other) { return (point.placeOf(other) - place).norm(); };
      const AtVertex vertex = point.asVertex(at);
      EXPECT_NE(std::find(corners.begin(), corners.end(), vertex.vertex), corners.end());
      for (const Index corner : corners) EXPECT_LE(distanceTo(vertex), distanceTo(AtVertex{corner}));
      const AtEdge edge = point.asEdge(at);
      // Steps along all sides come nowhere nearer.
      constexpr int kSteps = 64;
      for (std::size_t k = 0; k < corners.size(); ++k)
        for (int step = 0; step <= kSteps; ++step)
          EXPECT_LE(distanceTo(edge), (1 + 1e-12) * distanceTo(AtEdge{corners[k], corners[(k + 1) % corners.size()],
                                                                      static_cast<double>(step) / kSteps}));
    }
  }
}

TEST(LocationKind, OfAPointNearTheSurfaceStartsFromWhatItLiesOn)
{
  PointOf point(test::grid(4, 4));
  EXPECT_EQ(point.asVertex(AtNear{{2, 1, 9}}).vertex, 7);
  const AtEdge edge = point.asEdge(AtNear{{2, 1.25, -3}});
  EXPECT_THAT((std::array{edge.i, edge.j}), ElementsAre(7, 12));
  EXPECT_EQ(edge.t, 0.75);
  const AtFace face = point.asFace(AtNear{{2.25, 1.125, 4}});
  EXPECT_LT((point.placeOf(face) - Vector3(2.25, 1.125, 0)).norm(), 1e-15);
  EXPECT_EQ(point.asVertex(AtNear{{2.25, 1.125, 4}}).vertex, 7);
  const AtEdge side = point.asEdge(AtNear{{2.5, 1.125, 4}});
  EXPECT_LT((point.placeOf(side) - Vector3(2.5, 1, 0)).norm(), 1e-15) << "the side below it";
}

TEST(LocationKind, OfPolygonsCountsAllTheirCorners)
{
  // A square, and beside it a hexagon with a vertex more, 5, in the middle of the common side.
  Mesh mesh;
  mesh.positions.resize(8, 3);
  mesh.positions << 0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0, 4, 0, 0, 2, 1, 0, 4, 2, 0, 5, 1, 0;
  mesh.faces.add({0, 1, 2, 3});
  mesh.faces.add({1, 4, 7, 6, 2, 5});
  PointOf point(std::move(mesh));
  EXPECT_EQ(point.asVertex(AtFace{1, {0.25, 0, 0, 0, 0.25, 0.5}}).vertex, 5);
  const AtFace hexagon = point.asFace(AtEdge{5, 1, 0.25});
  EXPECT_EQ(hexagon.face, 1);
  EXPECT_THAT(hexagon.weights, ElementsAre(0.75, 0, 0, 0, 0, 0.25));
  const AtEdge side = point.asEdge(AtFace{0, {0, 0.5, 0.25, 0.25}});
  EXPECT_LT((point.placeOf(side) - Vector3(2, 1, 0)).norm(), 1e-15);
  EXPECT_EQ(std::get<AtNear>(point.as(LocationKind::Near, AtFace{0, {0.25, 0.25, 0.25, 0.25}})).place,
            Vector3(1, 1, 0));
}

TEST(LocationKind, OfTheSameKindIsTheSameLocation)
{
  PointOf point(test::grid(2, 2));
  EXPECT_EQ(std::get<AtNear>(point.as(LocationKind::Near, AtNear{{1, 1, 9}})).place, Vector3(1, 1, 9));
  const AtEdge edge = point.asEdge(AtEdge{4, 7, 1});
  EXPECT_THAT((std::array{edge.i, edge.j}), ElementsAre(4, 7)) << "though it is at a vertex";
  EXPECT_THAT(point.asFace(AtFace{3, {1e-15, 0.2, 0.8}}).weights, ElementsAre(1e-15, 0.2, 0.8));
}

TEST(LocationKind, OfAVertexThatNoFaceUsesIsRefused)
{
  PointOf point(test::withVertex(test::grid(1, 1), {9, 9, 9}));
  for (const LocationKind kind : {LocationKind::Edge, LocationKind::Face, LocationKind::Near})
    EXPECT_THAT(point.refusal(kind, AtVertex{4}), HasSubstr("no face uses vertex 4"));
  EXPECT_EQ(point.refusal(LocationKind::Vertex, AtVertex{4}), "");
}

TEST(LocationKind, OfAVertexWithoutAnEdgeIsRefusedAsAnEdgeAlone)
{
  Mesh mesh = test::withVertex(test::grid(1, 1), {9, 9, 9});
  mesh.faces.add({4, 4, 4});
  PointOf point(std::move(mesh));
  EXPECT_THAT(point.refusal(LocationKind::Edge, AtVertex{4}), HasSubstr("no edge joins vertex 4"));
  EXPECT_THAT(point.asFace(AtVertex{4}).weights, ElementsAre(1, 0, 0));
}

TEST(LocationKind, OfWhatTheMeshDoesNotHaveIsRefusedAsTheLocatorDoes)
{
  PointOf point(test::grid(1, 1));
  EXPECT_THAT(point.refusal(LocationKind::Face, AtVertex{4}), HasSubstr("there is no vertex 4"));
  EXPECT_THAT(point.refusal(LocationKind::Vertex, AtFace{7, {1, 0, 0}}), HasSubstr("there is no face 7"));
}

}  // namespace
}  // namespace holdfast
