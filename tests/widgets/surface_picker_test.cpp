#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkRenderer.h>

#include <holdfast/geometry/bounding_box.h>
#include <holdfast/surface/surface_locator.h>
#include <holdfast/widgets/picking/surface_picker.h>

#include "support/law_meshes.h"
#include "support/meshes.h"
#include "support/random.h"
#include "widgets/plain_view.h"

namespace holdfast {
namespace {

using test::PlainView;
using test::Projection;

constexpr double kSnap = 8;

/// A model in a view.
struct Shown {
  Shown(Mesh mesh, const PlainView& from) : model(makeModel(std::move(mesh), "mesh")), view(from), screen(from) {}

  std::optional<SurfacePick> pick(const Eigen::Vector2d& pixel, PickKind kind, double snapPixels = kSnap)
  {
    return picker.pick(screen.renderer(), pixel.x(), pixel.y(), kind, snapPixels);
  }

  /// The pixel in which a place is shown.
  [[nodiscard]] Eigen::Vector2d pixelOf(const Vector3& place) const
  {
    return view.shown(place).head<2>().array().floor();
  }

  /// On the screen, from the center of a pixel.
  [[nodiscard]] double distance(const Vector3& place, const Eigen::Vector2d& pixel) const
  {
    return (view.shown(place).head<2>() - pixel - Eigen::Vector2d(0.5, 0.5)).norm();
  }

  Model model;
  PlainView view;
  test::PlainScreen screen;
  SurfacePicker picker{std::make_shared<const VisibleSurface>(model)};
  Positions positions = model.mesh.positions;
};

std::vector<PlainView> viewsOf(const Mesh& mesh, test::Random& random)
{
  const Vector3 middle = mesh.positions.colwise().mean().transpose();
  const double far = 2 * boundingBoxDiagonal(mesh.positions);
  std::vector<PlainView> views;
  for (const Projection projection : {Projection::Perspective, Projection::Parallel})
    for (int k = 0; k < 3; ++k) {
      const Vector3 away(random.uniform(0.2, 1), random.uniform(-1, 1), random.uniform(-1, 1));
      views.push_back({middle + far * away.normalized(), middle, projection});
    }
  return views;
}

/// Calls `check(shown, pixel)` for pixels all over meshes of all kinds.
template <class Check>
void forEachPixel(std::uint32_t seed, int pixels, Check&& check)
{
  test::Random random(seed);
  for (const test::NamedMesh& named : test::lawMeshes())
    for (const PlainView& view : viewsOf(named.mesh, random)) {
      SCOPED_TRACE(named.name + (view.projection == Projection::Parallel ? ", parallel" : ", perspective"));
      Shown shown(named.mesh, view);
      for (int k = 0; k < pixels; ++k)
        check(shown, Eigen::Vector2d(static_cast<double>(random.integer(0, view.width - 1)),
                                     static_cast<double>(random.integer(0, view.height - 1))));
    }
}

/// The place of a location by its weights.
Vector3 placeOf(const SurfaceLocation& location, const Shown& shown)
{
  const Triangulation& triangulation = shown.model.triangulation;
  SurfaceLocator locator(shown.model.mesh, triangulation);
  return positionOf(locator.locate(location, {}), shown.positions);
}

TEST(SurfacePicker, FacePicksAreThoseOfASearchThroughAllTriangles)
{
  int hits = 0;
  forEachPixel(61, 40, [&](Shown& shown, const Eigen::Vector2d& pixel) {
    const auto& triangulation = shown.model.triangulation;
    const Eigen::Vector2d center = pixel + Eigen::Vector2d(0.5, 0.5);
    const test::PlainSight sight =
        test::plainSight(shown.view, center, shown.model.mesh.positions, triangulation.triangles);
    if (sight.isDoubtful) return;
    const auto pick = shown.pick(pixel, PickKind::Face);
    ASSERT_EQ(pick ? pick->triangle : -1, sight.triangle);
    if (!pick) return;
    ++hits;
    const auto& at = std::get<AtFace>(pick->location);
    EXPECT_EQ(pick->face, triangulation.faceOf[sight.triangle]);
    EXPECT_EQ(at.face, pick->face);
    ASSERT_EQ(at.weights.size(), shown.model.mesh.faces[at.face].size());
    EXPECT_GE(*std::min_element(at.weights.begin(), at.weights.end()), 0);
    EXPECT_NEAR(std::accumulate(at.weights.begin(), at.weights.end(), 0.0), 1, 1e-15);
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(at.weights[triangulation.cornersOf(sight.triangle)[k]], sight.weights[k], 1e-9);
    EXPECT_NEAR(shown.distance(pick->place, pixel), 0, 1e-9);
    EXPECT_NEAR((placeOf(at, shown) - pick->place).norm(), 0, 1e-14 * shown.model.solverMesh.diagonal);
  });
  EXPECT_GT(hits, 300);
}

/// The nearest of the visible vertices; nothing where rounding decides what is visible.
struct NearestVertex {
  double distance = std::numeric_limits<double>::infinity();
  std::optional<Index> vertex = -1;
};

NearestVertex nearestVisibleVertex(const Shown& shown, const Eigen::Vector2d& pixel)
{
  NearestVertex nearest;
  for (Index v = 0; v < shown.model.mesh.vertexCount(); ++v) {
    const Vector3 place = shown.positions.row(v);
    const double distance = shown.distance(place, pixel);
    if (distance > kSnap || distance >= nearest.distance) continue;
    const auto isVisible =
        test::isPlainlyVisible(shown.view, place, {v}, shown.positions, shown.model.triangulation.triangles);
    if (!isVisible) return {distance, std::nullopt};
    if (*isVisible) nearest = {distance, v};
  }
  return nearest;
}

TEST(SurfacePicker, VerticesNearTheCursorComeFirst)
{
  int snapped = 0;
  forEachPixel(62, 60, [&](Shown& shown, const Eigen::Vector2d& pixel) {
    const NearestVertex nearest = nearestVisibleVertex(shown, pixel);
    if (!nearest.vertex) return;
    const auto pick = shown.pick(pixel, PickKind::Nearest);
    const auto* const at = pick ? std::get_if<AtVertex>(&pick->location) : nullptr;
    ASSERT_EQ(at ? at->vertex : -1, *nearest.vertex) << pixel.transpose() << ", " << nearest.distance << " pixels";
    if (!at) return;
    ++snapped;
    EXPECT_EQ(pick->place, shown.positions.row(at->vertex).transpose());
    EXPECT_THAT(shown.model.triangulation.triangles[pick->triangle], testing::Contains(at->vertex));
    EXPECT_EQ(shown.model.triangulation.faceOf[pick->triangle], pick->face);
  });
  EXPECT_GT(snapped, 100);
}

/// How far the nearest point of a visible edge of a face is from the center of a pixel; nothing where rounding decides.
std::optional<double> nearestVisibleEdge(const Shown& shown, const Eigen::Vector2d& pixel)
{
  const Mesh& mesh = shown.model.mesh;
  const Eigen::Vector2d center = pixel + Eigen::Vector2d(0.5, 0.5);
  double nearest = std::numeric_limits<double>::infinity();
  for (Index f = 0; f < mesh.faces.size(); ++f)
    for (std::size_t k = 0; k < mesh.faces[f].size(); ++k) {
      const Index i = mesh.faces[f][k];
      const Index j = mesh.faces[f][(k + 1) % mesh.faces[f].size()];
      const Vector3 a = shown.view.shown(shown.positions.row(i));
      const Vector3 b = shown.view.shown(shown.positions.row(j));
      const Eigen::Vector2d along = (b - a).head<2>();
      const double s = std::clamp((center - a.head<2>()).dot(along) / along.squaredNorm(), 0.0, 1.0);
      const Eigen::Vector2d point = a.head<2>() + s * along;
      const double distance = (point - center).norm();
      if (distance > kSnap || distance >= nearest) continue;
      // 1 / depth grows evenly along the screen in perspective, depth itself otherwise.
      const double depth =
          shown.view.projection == Projection::Parallel ? a[2] + s * (b[2] - a[2]) : 1 / ((1 - s) / a[2] + s / b[2]);
      const auto isVisible = test::isPlainlyVisible(shown.view, shown.view.placeAt(point, depth), {i, j},
                                                    shown.positions, shown.model.triangulation.triangles);
      if (!isVisible) return std::nullopt;
      if (*isVisible) nearest = distance;
    }
  return nearest;
}

TEST(SurfacePicker, EdgesComeNextAndFacesLast)
{
  int edges = 0;
  int faces = 0;
  forEachPixel(63, 60, [&](Shown& shown, const Eigen::Vector2d& pixel) {
    const auto nearest = nearestVisibleEdge(shown, pixel);
    if (!nearest || nearestVisibleVertex(shown, pixel).vertex != -1) return;
    const auto pick = shown.pick(pixel, PickKind::Nearest);
    if (std::isinf(*nearest)) {
      if (!pick) return;
      EXPECT_TRUE(std::holds_alternative<AtFace>(pick->location)) << pixel.transpose();
      ++faces;
      return;
    }
    ASSERT_TRUE(pick) << pixel.transpose();
    const auto* const at = std::get_if<AtEdge>(&pick->location);
    ASSERT_TRUE(at) << pixel.transpose();
    ++edges;
    EXPECT_LT(at->i, at->j);
    EXPECT_NEAR(shown.distance(pick->place, pixel), *nearest, 1e-9);
    EXPECT_NEAR((placeOf(*at, shown) - pick->place).norm(), 0, 1e-14 * shown.model.solverMesh.diagonal);
    EXPECT_THAT(shown.model.triangulation.triangles[pick->triangle], testing::IsSupersetOf({at->i, at->j}));
  });
  EXPECT_GT(edges, 150);
  EXPECT_GT(faces, 40);
}

TEST(SurfacePicker, ForcedKindsTakeTheNearestOfTheFace)
{
  Shown shown(test::moved(test::grid(1, 1), {-0.5, -0.5, 0}), {{0, 0, 3}, {0, 0, 0}});
  // Below the diagonal, nearest to the corner (0.5, -0.5) and, by a little, to the side y = -0.5.
  const Eigen::Vector2d pixel = shown.pixelOf({0.2, -0.25, 0});
  const auto vertex = shown.pick(pixel, PickKind::Vertex);
  ASSERT_TRUE(vertex);
  EXPECT_EQ(std::get<AtVertex>(vertex->location).vertex, 1);
  const auto edge = shown.pick(pixel, PickKind::Edge);
  ASSERT_TRUE(edge);
  const auto& at = std::get<AtEdge>(edge->location);
  EXPECT_EQ(at.i, 0);
  EXPECT_EQ(at.j, 1);
  EXPECT_NEAR(at.t, 0.3, 0.01);
  EXPECT_TRUE(std::holds_alternative<AtFace>(shown.pick(pixel, PickKind::Nearest)->location));
}

TEST(SurfacePicker, CutsThroughPolygonsAreNoEdges)
{
  Shown shown(test::moved(test::quadBox({2, 2, 2}, 1), {0, 0, 0}), {{1, 1, 9}, {1, 1, 1}});
  const Vector3 middle = shown.positions.colwise().mean().transpose();
  shown.screen.look({middle + Vector3(0, 0, 9), middle});
  shown.view = {middle + Vector3(0, 0, 9), middle};
  const auto pick = shown.pick(shown.pixelOf(middle), PickKind::Nearest);
  ASSERT_TRUE(pick);
  EXPECT_EQ(std::get<AtFace>(pick->location).weights.size(), 4U);
  const auto edge = shown.pick(shown.pixelOf(middle), PickKind::Edge);
  ASSERT_TRUE(edge);
  const auto& at = std::get<AtEdge>(edge->location);
  EXPECT_EQ((shown.positions.row(at.i) - shown.positions.row(at.j)).norm(), 2) << "a side, not a diagonal";
}

/// A plate of two triangles before a wider one of many.
Mesh plates()
{
  Mesh back = test::moved(test::grid(8, 8), {-4.2, -4.2, 0});
  back.positions *= 0.5;
  return test::merged(test::moved(test::grid(1, 1), {-0.5, -0.5, 1}), back);
}

TEST(SurfacePicker, HiddenPartsAreNeverPicked)
{
  for (const Projection projection : {Projection::Perspective, Projection::Parallel}) {
    Shown shown(plates(), {{0, 0, 9}, {0, 0, 0}, projection});
    for (Index v = 4; v < shown.model.mesh.vertexCount(); ++v) {
      const Eigen::Vector2d pixel = shown.pixelOf(shown.positions.row(v));
      const bool isHidden = shown.positions.row(v).head<2>().cwiseAbs().maxCoeff() < 0.5;
      for (const PickKind kind : {PickKind::Nearest, PickKind::Vertex, PickKind::Edge, PickKind::Face}) {
        const auto pick = shown.pick(pixel, kind);
        if (!pick) continue;
        EXPECT_EQ(isHidden, pick->place.z() == 1) << v;
      }
      const auto nearest = shown.pick(pixel, PickKind::Nearest);
      const bool isClear = pixel.x() > 20 && pixel.y() > 20 && pixel.x() < 380 && pixel.y() < 280;
      if (isHidden || !isClear || !nearest || nearest->place.z() == 1) continue;
      EXPECT_EQ(std::get<AtVertex>(nearest->location).vertex, v);
    }
  }
}

TEST(SurfacePicker, FacesThatAreNotShownArePickedThrough)
{
  for (const PickKind kind : {PickKind::Nearest, PickKind::Vertex, PickKind::Edge, PickKind::Face}) {
    Shown shown(plates(), {{0, 0, 9}, {0, 0, 0}, Projection::Perspective});
    const Vector3 middle = Vector3::Zero();
    ASSERT_EQ(shown.pick(shown.pixelOf(middle), kind)->place.z(), 1) << "the plate in front";
    auto isHidden = std::make_shared<std::vector<char>>();
    for (const Triangle& triangle : shown.model.triangulation.triangles)
      isHidden->push_back(shown.positions(triangle[0], 2) == 1 ? 1 : 0);
    const VisibleSurface all(shown.model);
    const auto some = std::make_shared<const VisibleSurface>(all.withHidden(isHidden));
    const Eigen::Vector2d pixel = shown.pixelOf(middle);
    const auto pick = SurfacePicker(some).pick(shown.screen.renderer(), pixel.x(), pixel.y(), kind, kSnap);
    ASSERT_TRUE(pick);
    EXPECT_LT(pick->place.z(), 1);
    for (Index v = 0; v < shown.model.mesh.vertexCount(); ++v) {
      EXPECT_TRUE(all.isShown(v));
      EXPECT_EQ(some->isShown(v), shown.positions(v, 2) != 1);
    }
  }
}

TEST(SurfacePicker, EdgesOfWhatIsInFrontCatchTheCursorBesideThem)
{
  Shown shown(plates(), {{0, 0, 9}, {0, 0, 0}});
  const Eigen::Vector2d onEdge = shown.pixelOf({0.5, 0.27, 1});
  const auto beside = shown.pick(onEdge + Eigen::Vector2d(4, 0), PickKind::Nearest);
  ASSERT_TRUE(beside);
  EXPECT_EQ(beside->place.z(), 1);
  EXPECT_TRUE(std::holds_alternative<AtEdge>(beside->location));
  const auto face = shown.pick(onEdge + Eigen::Vector2d(4, 0), PickKind::Face);
  ASSERT_TRUE(face);
  EXPECT_NEAR(face->place.z(), 0, 1e-12);
}

TEST(SurfacePicker, BesideTheSurfaceOnlyWhatIsInReachIsPicked)
{
  Shown shown(test::moved(test::grid(1, 1), {-0.5, -0.5, 0}), {{0, 0, 3}, {0, 0, 0}});
  const Eigen::Vector2d corner = shown.pixelOf({0.5, 0.5, 0});
  const Eigen::Vector2d side = shown.pixelOf({0.5, 0, 0});
  for (const PickKind kind : {PickKind::Nearest, PickKind::Vertex, PickKind::Edge, PickKind::Face}) {
    EXPECT_FALSE(shown.pick(side + Eigen::Vector2d(12, 0), kind));
    EXPECT_FALSE(shown.pick(side + Eigen::Vector2d(3, 0), kind, 0));
  }
  EXPECT_FALSE(shown.pick(side + Eigen::Vector2d(5, 0), PickKind::Face));
  EXPECT_FALSE(shown.pick(side + Eigen::Vector2d(5, 0), PickKind::Vertex));
  EXPECT_TRUE(std::holds_alternative<AtEdge>(shown.pick(side + Eigen::Vector2d(5, 0), PickKind::Nearest)->location));
  EXPECT_TRUE(
      std::holds_alternative<AtVertex>(shown.pick(corner + Eigen::Vector2d(4, 4), PickKind::Nearest)->location));
  EXPECT_FALSE(shown.pick(corner + Eigen::Vector2d(7, 7), PickKind::Nearest));
}

TEST(SurfacePicker, OpenSurfacesArePickedFromBehind)
{
  const Mesh plate = test::moved(test::grid(1, 1), {-0.5, -0.5, 0});
  Shown front(plate, {{0, 0, 3}, {0, 0, 0}});
  Shown back(plate, {{0, 0, -3}, {0, 0, 0}});
  const Vector3 place(0.2, 0.1, 0);
  const auto fromFront = front.pick(front.pixelOf(place), PickKind::Face);
  const auto fromBack = back.pick(back.pixelOf(place), PickKind::Face);
  ASSERT_TRUE(fromFront && fromBack);
  EXPECT_EQ(fromFront->triangle, fromBack->triangle);
  EXPECT_NEAR((fromFront->place - fromBack->place).norm(), 0, 0.02);
}

TEST(SurfacePicker, PicksFollowTheSurface)
{
  Shown shown(test::moved(test::grid(1, 1), {-0.5, -0.5, 0}), {{0, 0, 9}, {0, 0, 0}});
  const Eigen::Vector2d middle = shown.pixelOf({0, 0, 0});
  ASSERT_TRUE(shown.pick(middle, PickKind::Face));
  Positions moved = shown.positions;
  moved.col(0).array() += 1;
  shown.picker = SurfacePicker(std::make_shared<const VisibleSurface>(
      shown.picker.surface()->movedTo(std::make_shared<const Positions>(moved))));
  EXPECT_FALSE(shown.pick(middle, PickKind::Face));
  const auto pick = shown.pick(shown.pixelOf({1.2, 0.1, 0}), PickKind::Face);
  ASSERT_TRUE(pick);
  EXPECT_NEAR(pick->place.x(), 1.2, 0.02);
  const auto vertex = shown.pick(shown.pixelOf({1.5, 0.5, 0}), PickKind::Nearest);
  ASSERT_TRUE(vertex);
  EXPECT_EQ(std::get<AtVertex>(vertex->location).vertex, 3);
}

TEST(SurfacePicker, WhatLiesBehindTheEyeIsNotPicked)
{
  Shown shown(test::icosphere(1), {{0, 0, 0.2}, {0, 0, -5}});
  for (const PickKind kind : {PickKind::Nearest, PickKind::Vertex, PickKind::Edge, PickKind::Face})
    for (double x = 5; x < 400; x += 30) {
      const auto pick = shown.pick({x, 150}, kind);
      ASSERT_TRUE(pick || kind == PickKind::Vertex) << "the eye is enclosed";
      if (pick) {
        EXPECT_LT(pick->place.z(), 0.2);
      }
    }
}

TEST(SurfacePicker, EdgesThatPassTheEyeArePickedInFrontOfIt)
{
  // A floor under the eye that reaches from far behind it to far before it.
  Shown shown(test::triangle({-50, -1, 50}, {50, -1, 50}, {0.3, -1, -50}), {{0, 0, 0}, {0, 0, -5}});
  const auto pick = shown.pick({200, 60}, PickKind::Edge);
  ASSERT_TRUE(pick);
  EXPECT_LT(pick->place.z(), 0);
  const auto& at = std::get<AtEdge>(pick->location);
  EXPECT_GE(at.t, 0);
  EXPECT_LE(at.t, 1);
  EXPECT_EQ(at.j, 2) << "not the edge behind the eye";
}

}  // namespace
}  // namespace holdfast
